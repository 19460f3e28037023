#include "CaseFacts.h"

#include "../model/CaseMeasuring.h"
#include "../model/OpenCase.h"
#include "../model/PrepareModel.h"

#include <insonate/ui/Theme.h>
#include <insonate/views/SlicePlane.h>

#include <QDir>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>

namespace insonate::prepare {
namespace {

QString number(double value, int decimals) {
  QString text = QString::number(value, 'f', decimals);
  while (text.contains('.') && (text.endsWith('0') || text.endsWith('.'))) text.chop(1);
  return text;
}

/// Directions of the grid's three axes in the patient.
QString axesOf(const VolumeGeometry& grid) {
  QStringList letters;
  for (const Vec3& axis : grid.direction.column) letters << QString::fromStdString(views::orientationLetters(axis));
  return letters.join(QStringLiteral(", "));
}

/// Identifiers without spaces may break anywhere.
QString breakable(const QString& text) {
  constexpr int kLongest = 16;
  const QChar kBreakHere(0x200b);
  QString result;
  int run = 0;
  for (const QChar& letter : text) {
    run = letter.isSpace() ? 0 : run + 1;
    result += letter;
    if (run > 0 && run % kLongest == 0) result += kBreakHere;
  }
  return result;
}

}  // namespace

CaseFacts::CaseFacts(PrepareModel& shared, QWidget* parent) : QWidget(parent), shared_(shared), title_(new QLineEdit) {
  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 0, 0);
  form->setHorizontalSpacing(ui::kGap);
  form->setVerticalSpacing(ui::kSmallGap);
  form->setRowWrapPolicy(QFormLayout::DontWrapRows);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  title_->setObjectName(QStringLiteral("caseTitle"));
  title_->setAccessibleName(tr("Title of the case"));
  title_->setToolTip(tr("Title of the case; saved with the case"));
  title_->setMaxLength(120);
  form->addRow(title_);
  size_ = addFact(*form, tr("voxels"));
  size_->setObjectName(QStringLiteral("caseSize"));
  spacing_ = addFact(*form, tr("voxel spacing"));
  orientation_ = addFact(*form, tr("axis directions"));
  orientation_->setToolTip(
      tr("Anatomical direction of each voxel axis: L left, R right, P back, A front, S head, I feet"));
  range_ = addFact(*form, tr("value range"));
  range_->setObjectName(QStringLiteral("caseRange"));
  place_ = addFact(*form, tr("folder"));
  place_->setObjectName(QStringLiteral("caseFolder"));
  source_ = addFact(*form, tr("source"));
  notes_ = addFact(*form, tr("import notes"));
  notes_->setObjectName(QStringLiteral("caseNotes"));
  connect(title_, &QLineEdit::editingFinished, this, [this] { shared_.openCase.setTitle(title_->text()); });
  connect(&shared_.openCase, &OpenCase::titleChanged, this, [this] { title_->setText(shared_.openCase.title()); });
  connect(&shared_.openCase, &OpenCase::caseChanged, this, [this] { showCase(); });
  connect(&shared_.openCase, &OpenCase::originChanged, this, [this] { showOrigin(); });
  connect(&shared_.measuring, &CaseMeasuring::changed, this, [this] { showMeasures(); });
  showCase();
}

QLabel* CaseFacts::addFact(QFormLayout& form, const QString& name) {
  auto* label = new QLabel(name);
  ui::setRole(label, "quiet");
  label->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  auto* fact = new QLabel;
  fact->setWordWrap(true);
  // The longest word must not widen the column.
  fact->setMinimumWidth(1);
  fact->setTextInteractionFlags(Qt::TextSelectableByMouse);
  fact->setAccessibleName(name);
  form.addRow(label, fact);
  return fact;
}

void CaseFacts::showCase() {
  const auto& patient = shared_.openCase.patient();
  title_->setText(shared_.openCase.title());
  if (!patient) return;
  const VolumeGeometry& grid = patient->ct.geometry;
  size_->setText(QStringLiteral("%1 x %2 x %3").arg(grid.size[0]).arg(grid.size[1]).arg(grid.size[2]));
  spacing_->setText(tr("%1 x %2 x %3 mm")
                        .arg(number(grid.spacing_mm.x, 3), number(grid.spacing_mm.y, 3), number(grid.spacing_mm.z, 3)));
  orientation_->setText(axesOf(grid));
  const QString source = QString::fromStdString(patient->manifest.source);
  source_->setText(source.isEmpty() ? tr("unknown") : breakable(source));
  showOrigin();
  showMeasures();
}

void CaseFacts::showOrigin() {
  const ui::CaseOrigin& origin = shared_.openCase.origin();
  place_->setText(origin.builtIn                ? tr("built-in case of Insonate")
                  : origin.isDownloaded()       ? tr("downloaded from the server")
                  : !origin.versionOf.isEmpty() ? tr("a version of %1").arg(QDir(origin.versionOf).dirName())
                  : origin.folder.isEmpty()     ? tr("not saved yet")
                                                : QDir(origin.folder).dirName());
  place_->setToolTip(origin.versionOf.isEmpty() ? origin.folder : origin.versionOf);
  QStringList notes = origin.notes;
  if (shared_.openCase.patient())
    for (const std::string& note : shared_.openCase.patient()->manifest.importNotes)
      notes << QString::fromStdString(note);
  notes.removeDuplicates();
  notes_->setText(notes.isEmpty() ? tr("no changes") : notes.join(QLatin1Char('\n')));
}

void CaseFacts::showMeasures() {
  const auto& measures = shared_.measuring.measures();
  range_->setText(measures ? tr("%1 to %2 HU").arg(measures->statistics.min_HU).arg(measures->statistics.max_HU)
                           : tr("..."));
}

}  // namespace insonate::prepare
