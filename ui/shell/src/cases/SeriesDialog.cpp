#include "SeriesDialog.h"

#include "SlicePreview.h"

#include <insonate/ui/PlainToolTip.h>
#include <insonate/ui/TaskBar.h>
#include <insonate/ui/Theme.h>
#include <insonate/views/SlicePlane.h>

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTableWidget>
#include <algorithm>
#include <utility>

namespace insonate::ui {
namespace {

constexpr int kPicture_px = 260, kLeftOut_px = 72, kWidestColumn_px = 220;
constexpr int kKernelColumn = 3, kDescriptionColumn = 4, kDateColumn = 5, kBodyPartColumn = 6, kSeriesColumn = 7,
              kNotesColumn = 8;

QString sizeOf(const VolumeGeometry& grid) {
  return QStringLiteral("%1 x %2 x %3").arg(grid.size[0]).arg(grid.size[1]).arg(grid.size[2]);
}

QString spacingOf(const SeriesInfo& series) {
  if (!series.geometryKnown) return SeriesDialog::tr("unknown");
  const Vec3 s = series.geometry.spacing_mm;
  return QStringLiteral("%1 x %2 x %3").arg(s.x, 0, 'f', 2).arg(s.y, 0, 'f', 2).arg(s.z, 0, 'f', 2);
}

/// The name of a file; for a DICOM series, the end of its UID, which distinguishes it.
QString nameOf(const SeriesInfo& series) {
  constexpr int kLongest = 28, kEnd = 8;
  const QString uid = QString::fromStdString(series.uid);
  if (!series.modality.empty()) return uid.size() > kEnd ? QStringLiteral("... ") + uid.right(kEnd) : uid;
  return uid.size() > kLongest ? QStringLiteral("... ") + uid.right(kLongest) : uid;
}

QString stateOf(const SeriesInfo& series) {
  if (!series.refusal.empty()) return SeriesDialog::tr("cannot be imported");
  if (series.warnings.empty()) return SeriesDialog::tr("no notes");
  const auto count = series.warnings.size();
  return count == 1 ? SeriesDialog::tr("1 note") : SeriesDialog::tr("%1 notes").arg(count);
}

/// Position of the volume that an import makes.
QString placeOf(const SeriesInfo& series) {
  const VolumeGeometry& g = series.geometry;
  QStringList axes;
  for (const Vec3& axis : g.direction.column) axes << QString::fromStdString(views::orientationLetters(axis));
  const auto number = [](double value) { return QString::number(value, 'f', 1); };
  return SeriesDialog::tr("%1 x %2 x %3 mm, axes toward %4, origin at %5, %6, %7 mm.")
      .arg(number(g.size[0] * g.spacing_mm.x), number(g.size[1] * g.spacing_mm.y), number(g.size[2] * g.spacing_mm.z),
           axes.join(QStringLiteral(", ")), number(g.origin_mm.x), number(g.origin_mm.y), number(g.origin_mm.z));
}

QString notesOf(const SeriesInfo& series) {
  QStringList lines;
  if (series.geometryKnown) lines << placeOf(series);
  if (!series.refusal.empty()) lines << QString::fromStdString(series.refusal);
  for (const std::string& warning : series.warnings) lines << QString::fromStdString(warning);
  if (series.refusal.empty() && series.warnings.empty())
    lines << SeriesDialog::tr("The geometry of this series is imported without changes.");
  return lines.join(QLatin1Char('\n'));
}

}  // namespace

SeriesDialog::SeriesDialog(const QString& path, std::shared_ptr<const SeriesListing> listing, QWidget* parent)
    : QDialog(parent),
      path_(path),
      listing_(std::move(listing)),
      overview_(overviewOf(*listing_)),
      table_(new QTableWidget(int(overview_.shown.size()), kNotesColumn + 1)),
      notes_(new QLabel),
      picture_(new QLabel),
      label_(new QCheckBox(tr("Label air, fat, muscle, bone and skin automatically"))),
      shift_(new QCheckBox),
      saturate_(new QCheckBox),
      import_(new QPushButton(tr("Import"))),
      tasks_(new TaskBar) {
  setWindowTitle(tr("Import"));
  fill();
  arrange();
  connect(table_, &QTableWidget::itemSelectionChanged, this, &SeriesDialog::showChosen);
  connect(table_, &QTableWidget::itemActivated, import_, &QPushButton::click);
  connect(shift_, &QCheckBox::toggled, this, &SeriesDialog::showPicture);
  connect(saturate_, &QCheckBox::toggled, this, &SeriesDialog::refreshImport);
  connect(import_, &QPushButton::clicked, this, [this] {
    // The Enter key in the table arrives in two ways.
    if (result() != Accepted) accept();
  });
  table_->selectRow(likeliestRow());
}

void SeriesDialog::fill() {
  table_->setHorizontalHeaderLabels({tr("Modality"), tr("Voxels"), tr("Spacing, mm"), tr("Kernel"), tr("Description"),
                                     tr("Date"), tr("Body part"), tr("Series"), tr("Notes")});
  for (int row = 0; row < table_->rowCount(); ++row) {
    const SeriesInfo& series = seriesAt(row);
    const QString modality = series.modality.empty() ? tr("unknown") : QString::fromStdString(series.modality);
    const QStringList cells{modality,
                            sizeOf(series.geometry),
                            spacingOf(series),
                            QString::fromStdString(series.kernel),
                            QString::fromStdString(series.description),
                            QString::fromStdString(series.date),
                            QString::fromStdString(series.bodyPart),
                            nameOf(series),
                            stateOf(series)};
    for (int column = 0; column < cells.size(); ++column) {
      auto* item = new QTableWidgetItem(cells[column]);
      item->setToolTip(plainToolTip(column == kDescriptionColumn ? cells[column] : QString::fromStdString(series.uid)));
      item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
      if (!series.refusal.empty()) item->setForeground(toQColor(views::theme::kQuiet));
      table_->setItem(row, column, item);
    }
  }
  for (const auto& [column, text] : {std::pair{kKernelColumn, &SeriesInfo::kernel},
                                     {kDescriptionColumn, &SeriesInfo::description},
                                     {kDateColumn, &SeriesInfo::date},
                                     {kBodyPartColumn, &SeriesInfo::bodyPart}})
    table_->setColumnHidden(column, std::ranges::all_of(listing_->series, &std::string::empty, text));
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setShowGrid(false);
  table_->verticalHeader()->hide();
  table_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setMaximumSectionSize(kWidestColumn_px);
  // Names of files may be long; notes are shown completely.
  table_->horizontalHeader()->setSectionResizeMode(kSeriesColumn, QHeaderView::Stretch);
  table_->setTextElideMode(Qt::ElideMiddle);
  table_->setTabKeyNavigation(false);
  table_->setAccessibleName(tr("Series"));
  table_->setToolTip(tr("Arrow keys choose a series, Enter imports the series"));
}

void SeriesDialog::setUpWidgets() {
  notes_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  notes_->setObjectName(QStringLiteral("importNotes"));
  notes_->setAccessibleName(tr("Description of the resulting case and of the changes to the series"));
  notes_->setWordWrap(true);
  notes_->setAlignment(Qt::AlignTop);
  notes_->setTextFormat(Qt::PlainText);
  setRole(notes_, "quiet");
  picture_->setFixedSize(kPicture_px, kPicture_px);
  picture_->setAlignment(Qt::AlignCenter);
  picture_->setAutoFillBackground(true);
  QPalette black = picture_->palette();
  black.setColor(QPalette::Window, toQColor(views::theme::kBlack));
  picture_->setPalette(black);
  picture_->setAccessibleName(tr("Middle slice of the chosen series"));
  label_->setChecked(true);
  label_->setToolTip(
      tr("Computes these labels from Hounsfield units; an author has to label vessels, glands and nerves"));
  shift_->setObjectName(QStringLiteral("shiftValues"));
  shift_->setToolTip(
      tr("The preview, automatic labels and ultrasound need Hounsfield units: air at -1000, water at 0"));
  // Its text states the amount, for which the file must be read.
  shift_->setAccessibleName(tr("Convert values to HU"));
  shift_->hide();
  saturate_->setObjectName(QStringLiteral("saturate"));
  saturate_->setToolTip(tr("Allows the import, although the scale of the values in the series is probably wrong"));
  saturate_->setAccessibleName(tr("Limit voxel values to 32767 HU"));
  saturate_->hide();
  import_->setToolTip(tr("Makes a case from the selected series; data that identify the patient are removed"));
  setRole(import_, "primary");
  import_->setDefault(true);
}

void SeriesDialog::arrange() {
  setUpWidgets();
  auto* title = new QLabel(tr("Series in %1").arg(QFileInfo(path_).fileName()));
  setRole(title, "title");
  title->setWordWrap(true);  // the name of a folder may be long
  QStringList omitted;
  for (const std::string& sentence : overview_.omitted) omitted << QString::fromStdString(sentence);
  if (const std::size_t skipped = listing_->skippedFiles.size(); skipped > 0)
    omitted << (skipped == 1 ? tr("1 file belongs to no series and is left out.")
                             : tr("%1 files belong to no series and are left out.").arg(skipped));
  auto* aside = new QLabel(omitted.join(QLatin1Char('\n')));
  aside->setObjectName(QStringLiteral("omitted"));
  aside->setTextFormat(Qt::PlainText);
  aside->setWordWrap(true);
  setRole(aside, "quiet");
  aside->setVisible(!omitted.isEmpty());
  QStringList reasons;
  for (const SkippedFile& file : listing_->skippedFiles)
    reasons << QString::fromStdString(file.file.filename().string() + ": " + file.reason);
  auto* leftOut = new QPlainTextEdit(reasons.join(QLatin1Char('\n')));
  leftOut->setReadOnly(true);
  leftOut->setTabChangesFocus(true);
  leftOut->setMaximumHeight(kLeftOut_px);
  leftOut->setVisible(!reasons.isEmpty());
  leftOut->setObjectName(QStringLiteral("leftOut"));
  leftOut->setAccessibleName(tr("Files that are left out, and why"));
  leftOut->setToolTip(leftOut->accessibleName());
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
  buttons->addButton(import_, QDialogButtonBox::ActionRole);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);

  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(kLargeGap, kLargeGap, kLargeGap, kLargeGap);
  grid->setSpacing(kGap);
  grid->addWidget(title, 0, 0, 1, 2);
  grid->addWidget(table_, 1, 0);
  grid->addWidget(picture_, 1, 1, Qt::AlignTop);
  grid->addWidget(notes_, 2, 0, 1, 2);
  grid->addWidget(aside, 3, 0, 1, 2);
  grid->addWidget(leftOut, 4, 0, 1, 2);
  grid->addWidget(shift_, 5, 0, 1, 2);
  grid->addWidget(saturate_, 6, 0, 1, 2);
  grid->addWidget(tasks_, 7, 0, 1, 2);
  auto* last = new QHBoxLayout;
  last->addWidget(label_, 1);
  last->addWidget(buttons);
  grid->addLayout(last, 8, 0, 1, 2);
  grid->setRowStretch(1, 1);
  grid->setColumnStretch(0, 1);
  resize(980, 480);
}

int SeriesDialog::likeliestRow() const {
  const auto worth = [](const SeriesInfo& series) {
    // Prefers a CT to other readable series, and the one with most slices among several.
    const int kind = !series.refusal.empty() ? 0 : series.modality == "CT" ? 2 : 1;
    return std::pair(kind, series.geometry.size[2]);
  };
  int best = 0;
  for (int row = 1; row < table_->rowCount(); ++row)
    if (worth(seriesAt(best)) < worth(seriesAt(row))) best = row;
  return best;
}

void SeriesDialog::noPicture(const Error& error) {
  if (error.message == kCancelled) return picture_->setText(tr("no preview"));
  // A slice that cannot be read for the preview cannot be imported either.
  picture_->setText(tr("no image"));
  notes_->setText(QString::fromStdString(error.message));
  import_->setEnabled(false);
}

int SeriesDialog::chosenRow() const {
  return table_->currentRow() >= 0 ? table_->currentRow() : 0;
}

const SeriesInfo& SeriesDialog::seriesAt(int row) const {
  return listing_->series[overview_.shown[std::size_t(row)]];
}

const SeriesInfo& SeriesDialog::chosenSeries() const {
  return seriesAt(chosenRow());
}

std::optional<int> SeriesDialog::wantedShift() const {
  return read_ && shift_->isChecked() ? read_->likelyShift_HU : std::nullopt;
}

ImportChoice SeriesDialog::choice() const {
  return {chosenSeries().uid, label_->isChecked(), wantedShift(), saturate_->isChecked(), read_};
}

void SeriesDialog::showChosen() {
  const SeriesInfo& series = chosenSeries();
  read_.reset();
  notes_->setText(notesOf(series));
  picture_->setPixmap({});
  shift_->hide();
  saturate_->hide();
  saturate_->setChecked(false);
  refreshImport();
  if (series.refusal.empty())
    preview();
  else
    tasks_->cancel();
}

void SeriesDialog::preview() {
  using Read = std::shared_ptr<ImportedCt>;
  picture_->setText(tr("reading ..."));
  tasks_->run<Read>(
      tr("Preview"),
      [path = path_.toStdString(), uid = chosenSeries().uid](const Progress& progress) -> Result<Read> {
        auto imported = importSeries(path, uid, progress);
        if (!imported) return tl::unexpected(imported.error());
        return std::make_shared<ImportedCt>(std::move(*imported));
      },
      [this](Result<Read> read) {
        if (!read) return noPicture(read.error());
        read_ = *read;
        showWhatWasRead();
      });
}

void SeriesDialog::refreshImport() {
  const bool asks = read_ && read_->saturatedVoxels > 0 && !saturate_->isChecked();
  import_->setEnabled(chosenSeries().refusal.empty() && !asks);
}

void SeriesDialog::showWhatWasRead() {
  QString notes = notesOf(read_->series);
  if (read_->saturatedVoxels > 0) notes += QLatin1Char('\n') + QString::fromStdString(saturationText(*read_));
  notes_->setText(notes);
  saturate_->setVisible(read_->saturatedVoxels > 0);
  saturate_->setText(read_->saturatedVoxels == 1
                         ? tr("Limit the value of 1 voxel to 32767 HU")
                         : tr("Limit the values of %1 voxels to 32767 HU").arg(read_->saturatedVoxels));
  refreshImport();
  table_->item(chosenRow(), kNotesColumn)->setText(stateOf(read_->series));
  const std::optional<int> likely = read_->likelyShift_HU;
  shift_->setVisible(likely.has_value());
  if (likely) shift_->setText(tr("Shift all values by %1: air, now 0, becomes %1 HU").arg(*likely));
  shift_->setChecked(likely.has_value());
  showPicture();
}

void SeriesDialog::showPicture() {
  if (read_) picture_->setPixmap(QPixmap::fromImage(slicePreview(read_->ct, kPicture_px, wantedShift().value_or(0))));
}

}  // namespace insonate::ui
