#include "LabelsDialog.h"

#include "SlicePreview.h"

#include <insonate/tissue/Labels.h>
#include <insonate/ui/PlainToolTip.h>
#include <insonate/ui/Text.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/Widgets.h>

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

namespace insonate::ui {
namespace {

constexpr int kPreview = 320;

enum MappingColumn { kInFile, kNameThere, kLabelHere, kVolume, kMappingColumns };

QTableWidget* mappingOf(const LabelReadResult& read, const std::array<std::size_t, 256>& voxels) {
  const Vec3 spacing = read.labels.geometry.spacing_mm;
  const double voxel_ml = spacing.x * spacing.y * spacing.z / 1000;
  auto* table = new QTableWidget(int(read.structures.size()), kMappingColumns);
  table->setObjectName(QStringLiteral("labelMapping"));
  table->setHorizontalHeaderLabels({LabelsDialog::tr("Number"), LabelsDialog::tr("Name in the file"),
                                    LabelsDialog::tr("Label in Insonate"), LabelsDialog::tr("Volume, ml")});
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table->setSelectionMode(QAbstractItemView::NoSelection);
  table->verticalHeader()->hide();
  for (int row = 0; row < table->rowCount(); ++row) {
    const ReadStructure& one = read.structures[row];
    const auto own = read.own.find(one.label);
    const QString here = own == read.own.end()
                             ? qt(labelName(one.label))
                             : LabelsDialog::tr("%1, treated as soft tissue").arg(qt(labelName(one.label)));
    table->setItem(row, kInFile, new QTableWidgetItem(QString::number(one.number)));
    auto* name = new QTableWidgetItem(one.name.empty() ? QStringLiteral("-") : qt(one.name));
    name->setToolTip(plainToolTip(name->text()));  // long names are cut
    table->setItem(row, kNameThere, name);
    table->setItem(row, kLabelHere, new QTableWidgetItem(here));
    auto* volume = new QTableWidgetItem(QString::number(double(voxels[one.label]) * voxel_ml, 'f', 1));
    volume->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    table->setItem(row, kVolume, volume);
  }
  table->resizeColumnsToContents();
  table->horizontalHeader()->setSectionResizeMode(kNameThere, QHeaderView::Stretch);
  return table;
}

}  // namespace

LabelsPreview labelsPreviewOf(const CtVolume& ct, const LabelReadResult& read) {
  LabelsPreview preview{labelPreview(ct, read.labels, read.colors, kPreview)};
  for (const std::uint8_t label : read.labels.voxels) ++preview.voxels[label];
  return preview;
}

LabelsDialog::LabelsDialog(const QString& fileName, const LabelReadResult& read, const LabelsPreview& preview,
                           QWidget* parent)
    : QDialog(parent), replace_(new QPushButton(tr("Replace labels"))) {
  setWindowTitle(tr("Import labels"));
  QLabel* title = paragraph("", "title", tr("Labels of %1").arg(fileName));
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
  row->addWidget(mappingOf(read, preview.voxels), 1);
  row->addWidget(picture);
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
  if (read.isUnnamed) addUnnamed(*box);
  box->addWidget(buttons);
  resize(900, 460);
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
                                     "table of 3D Slicer (.ctbl), or a JSON file of dcmqi or nnU-Net"));
  auto* row = new QHBoxLayout;
  row->setSpacing(kLargeGap);
  row->addWidget(areOurs_);
  row->addWidget(names);
  row->addStretch(1);
  box.addWidget(warning);
  box.addLayout(row);
  replace_->setEnabled(false);
  connect(areOurs_, &QCheckBox::toggled, replace_, &QWidget::setEnabled);
  connect(names, &QPushButton::clicked, this, [this] {
    reject();
    Q_EMIT namesRequested();
  });
}

}  // namespace insonate::ui
