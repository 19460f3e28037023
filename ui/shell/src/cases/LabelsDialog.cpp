#include "LabelsDialog.h"

#include "SlicePreview.h"

#include <insonate/simulator/ImportedLabels.h>
#include <insonate/tissue/Labels.h>
#include <insonate/ui/PlainToolTip.h>
#include <insonate/ui/Text.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/Widgets.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <optional>

namespace insonate::ui {
namespace {

constexpr int kPreview = 320;

enum MappingColumn { kTaken, kInFile, kNameThere, kLabelHere, kSide, kState, kVolume, kMappingColumns };
enum SideEntry { kUnknownSide, kRightSide, kLeftSide, kBothSides };

/// Entry of the list of sides; no value for a structure without a side.
std::optional<SideEntry> sideEntryOf(const ReadStructure& structure) {
  if (structure.state == StructureState::kDoubtful) return kUnknownSide;
  if (structure.vessel.starts_with("right ")) return kRightSide;
  if (structure.vessel.starts_with("left ")) return kLeftSide;
  return std::nullopt;
}

QString stateText(StructureState state) {
  switch (state) {
    case StructureState::kTaken:
      return LabelsDialog::tr("read");
    case StructureState::kLeftOut:
      return LabelsDialog::tr("left out");
    case StructureState::kEmpty:
      return LabelsDialog::tr("no voxels");
    case StructureState::kDoubtful:
      return LabelsDialog::tr("side?");
  }
  return {};
}

QString labelText(const LabelReadResult& read, const ReadStructure& structure) {
  if (!structure.vessel.empty()) return qt(structure.vessel);
  if (structure.state == StructureState::kLeftOut || structure.label == 0) return QStringLiteral("-");
  return read.own.contains(structure.label)
             ? LabelsDialog::tr("%1, treated as soft tissue").arg(qt(labelName(structure.label)))
             : qt(labelName(structure.label));
}

QTableWidgetItem* textItem(const QString& text, const QString& toolTip) {
  auto* item = new QTableWidgetItem(text);
  item->setToolTip(plainToolTip(toolTip));
  return item;
}

}  // namespace

LabelsPreview labelsPreviewOf(const CtVolume& ct, const LabelReadResult& read) {
  LabelsPreview preview{labelPreview(ct, read.labels, read.colors, kPreview)};
  for (const std::uint8_t label : read.labels.voxels) ++preview.voxels[label];
  return preview;
}

LabelsDialog::LabelsDialog(const QString& fileName, const LabelReadResult& read, const LabelsPreview& preview,
                           QWidget* parent)
    : QDialog(parent),
      rest_(new QCheckBox(tr("Label skin, air, bone, fat and muscle from the CT"))),
      replace_(new QPushButton(tr("Replace labels"))) {
  setWindowTitle(tr("Import labels"));
  QLabel* title = paragraph("", "title", tr("Labels in \"%1\"").arg(fileName));
  QLabel* about = paragraph(
      "", "quiet", tr("These structures will replace the labels of the case. Check their names and locations first."));
  auto* picture = new QLabel;
  picture->setObjectName(QStringLiteral("labelPreview"));
  picture->setPixmap(QPixmap::fromImage(preview.slice));
  picture->setToolTip(tr("The slice with the most labeled voxels"));
  picture->setAccessibleName(picture->toolTip());
  picture->setAlignment(Qt::AlignTop);
  auto* row = new QHBoxLayout;
  row->setSpacing(kLargeGap);
  row->addWidget(makeTable(read, preview), 1);
  row->addWidget(picture);
  rest_->setObjectName(QStringLiteral("labelRest"));
  rest_->setToolTip(tr("Vessels, thyroid and other imported structures replace the automatic labels"));
  rest_->setChecked(!read.isUnnamed && needsRest(read));
  setRole(replace_, "primary");
  replace_->setObjectName(QStringLiteral("replaceLabels"));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
  buttons->addButton(replace_, QDialogButtonBox::AcceptRole);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(kLargeGap, kLargeGap, kLargeGap, kLargeGap);
  box->setSpacing(kGap);
  box->addWidget(title);
  box->addWidget(about);
  box->addLayout(row, 1);
  QStringList missing;
  for (const std::string& sentence : missingForLines(read.structures)) missing << qt(sentence);
  if (!missing.isEmpty()) box->addWidget(paragraph("missingStructures", "", missing.join(QLatin1Char('\n'))));
  box->addWidget(rest_);
  if (read.isUnnamed) addUnnamed(*box);
  box->addWidget(buttons);
  enableReplace();
  resize(1100, 520);
}

QTableWidget* LabelsDialog::makeTable(const LabelReadResult& read, const LabelsPreview& preview) {
  const Vec3 spacing = read.labels.geometry.spacing_mm;
  const double voxel_ml = spacing.x * spacing.y * spacing.z / 1000;
  auto* table = new QTableWidget(int(read.structures.size()), kMappingColumns);
  table->setObjectName(QStringLiteral("labelMapping"));
  table->setHorizontalHeaderLabels({tr("Read"), tr("Number"), tr("Name in the file"), tr("Label in Insonate"),
                                    tr("Side"), tr("State"), tr("Volume, ml")});
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table->setSelectionMode(QAbstractItemView::NoSelection);
  table->verticalHeader()->hide();
  for (int row = 0; row < table->rowCount(); ++row) {
    const ReadStructure& one = read.structures[row];
    rows_.push_back(makeRow(*table, row, one));
    table->setItem(row, kInFile, new QTableWidgetItem(QString::number(one.number)));
    const QString name = one.name.empty() ? QStringLiteral("-") : qt(one.name);
    const QString details = one.details.empty() ? QString() : QStringLiteral(" (%1)").arg(qt(one.details));
    table->setItem(row, kNameThere, textItem(name, name + details));  // long names are cut
    table->setItem(row, kLabelHere, new QTableWidgetItem(labelText(read, one)));
    table->setItem(row, kState,
                   textItem(stateText(one.state), one.doubt.empty() ? stateText(one.state) : qt(one.doubt)));
    const std::size_t voxels = read.parts.voxels.empty() ? preview.voxels[one.label] : one.voxels;
    auto* volume = new QTableWidgetItem(QString::number(double(voxels) * voxel_ml, 'f', 1));
    volume->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    table->setItem(row, kVolume, volume);
  }
  table->resizeColumnsToContents();
  table->horizontalHeader()->setSectionResizeMode(kNameThere, QHeaderView::Stretch);
  connect(table, &QTableWidget::itemChanged, this, &LabelsDialog::enableReplace);
  return table;
}

LabelsDialog::Row LabelsDialog::makeRow(QTableWidget& table, int row, const ReadStructure& structure) {
  auto* taken = textItem({}, tr("Reads this structure"));
  taken->setFlags(Qt::ItemIsUserCheckable | Qt::ItemIsEnabled);
  const bool isTaken = structure.state != StructureState::kLeftOut;
  taken->setCheckState(isTaken ? Qt::Checked : Qt::Unchecked);
  table.setItem(row, kTaken, taken);
  const auto entry = sideEntryOf(structure);
  if (!entry) return {structure.key(), taken, isTaken, nullptr, kUnknownSide};
  auto* side = new QComboBox;
  side->addItems({tr("?"), tr("right"), tr("left"), tr("both")});
  side->setCurrentIndex(*entry);
  side->setAccessibleName(tr("Side of %1").arg(qt(structure.key())));
  table.setCellWidget(row, kSide, side);
  connect(side, qOverload<int>(&QComboBox::currentIndexChanged), this, &LabelsDialog::enableReplace);
  return {structure.key(), taken, isTaken, side, *entry};
}

StructureChoices LabelsDialog::choices() const {
  StructureChoices choices;
  for (const Row& row : rows_) {
    const bool isTaken = row.taken->checkState() == Qt::Checked;
    if (isTaken != row.wasTaken) choices.taken[row.key] = isTaken;
    const int side = row.side ? row.side->currentIndex() : int(kUnknownSide);
    if (!row.side || side == row.formerSide || side == kUnknownSide) continue;
    choices.sides[row.key] = side == kRightSide  ? SideAnswer::Right
                             : side == kLeftSide ? SideAnswer::Left
                                                 : SideAnswer::Both;
  }
  return choices;
}

bool LabelsDialog::labelsRest() const {
  return rest_->isChecked();
}

void LabelsDialog::enableReplace() {
  const bool isDoubtful = std::ranges::any_of(rows_, [](const Row& row) {
    return row.taken->checkState() == Qt::Checked && row.side && row.side->currentIndex() == kUnknownSide;
  });
  const bool isAnyTaken =
      std::ranges::any_of(rows_, [](const Row& row) { return row.taken->checkState() == Qt::Checked; });
  replace_->setEnabled(!isDoubtful && isAnyTaken && (!areOurs_ || areOurs_->isChecked()));
  replace_->setToolTip(isDoubtful ? tr("State the side of each vessel with a question mark first") : QString());
}

void LabelsDialog::addUnnamed(QVBoxLayout& box) {
  QLabel* warning = paragraph("", "",
                              tr("The file does not say what its numbers mean, and each program numbers structures in "
                                 "its own way. The table shows what each number would mean in Insonate."));
  areOurs_ = new QCheckBox(tr("Use Insonate's label numbers"));
  areOurs_->setObjectName(QStringLiteral("numbersAreOurs"));
  areOurs_->setToolTip(tr("Select this option only if the file was written with Insonate's label numbers"));
  QPushButton* names = pushButton("nameNumbers", tr("Read names from a file ..."),
                                  tr("Reads the names of the labels from a label description of ITK-SNAP, a color "
                                     "table of 3D Slicer (.ctbl), or a JSON file of dcmqi, nnU-Net or MONAI"));
  auto* row = new QHBoxLayout;
  row->setSpacing(kLargeGap);
  row->addWidget(areOurs_);
  row->addWidget(names);
  row->addStretch(1);
  box.addWidget(warning);
  box.addLayout(row);
  connect(areOurs_, &QCheckBox::toggled, this, &LabelsDialog::enableReplace);
  connect(names, &QPushButton::clicked, this, [this] {
    reject();
    Q_EMIT namesRequested();
  });
}

}  // namespace insonate::ui
