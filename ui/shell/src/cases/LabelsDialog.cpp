#include "LabelsDialog.h"

#include <insonate/tissue/Labels.h>
#include <insonate/ui/Text.h>
#include <insonate/ui/Theme.h>
#include <insonate/views/WindowLevel.h>

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>

namespace insonate::ui {
namespace {

constexpr int kPreview = 320;

enum MappingColumn { kInFile, kNameThere, kLabelHere, kVolume, kMappingColumns };

std::array<std::size_t, 256> voxelsOf(const LabelMap& labels) {
  std::array<std::size_t, 256> count{};
  for (const std::uint8_t label : labels.voxels) ++count[label];
  return count;
}

QTableWidget* mappingOf(const LabelReadResult& read) {
  const auto voxels = voxelsOf(read.labels);
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
    const QString here = own == read.own.end() ? qt(labelName(one.label))
                                               : LabelsDialog::tr("%1, as soft tissue").arg(qt(labelName(one.label)));
    table->setItem(row, kInFile, new QTableWidgetItem(QString::number(one.number)));
    table->setItem(row, kNameThere, new QTableWidgetItem(one.name.empty() ? QStringLiteral("-") : qt(one.name)));
    table->setItem(row, kLabelHere, new QTableWidgetItem(here));
    auto* volume = new QTableWidgetItem(QString::number(double(voxels[one.label]) * voxel_ml, 'f', 1));
    volume->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    table->setItem(row, kVolume, volume);
  }
  table->resizeColumnsToContents();
  table->horizontalHeader()->setSectionResizeMode(kNameThere, QHeaderView::Stretch);
  return table;
}

/// Index along k.
int fullestSlice(const LabelMap& labels) {
  const auto& size = labels.geometry.size;
  const std::size_t area = std::size_t(size[0]) * size[1];
  std::size_t most = 0;
  int fullest = size[2] / 2;
  for (int k = 0; k < size[2]; ++k) {
    const auto first = labels.voxels.begin() + std::ptrdiff_t(area * k);
    const auto labelled = std::size_t(std::count_if(first, first + std::ptrdiff_t(area), [](int v) { return v != 0; }));
    if (labelled > most) most = labelled, fullest = k;
  }
  return fullest;
}

}  // namespace

QImage labelPreview(const CtVolume& ct, const LabelReadResult& read, int side) {
  const auto& size = ct.geometry.size;
  const auto& axes = ct.geometry.direction.column;
  const bool mirrored = axes[0].x < 0, upsideDown = axes[1].y < 0;
  const views::WindowLevel softTissue;
  const int k = fullestSlice(read.labels);
  QImage slice(size[0], size[1], QImage::Format_RGB32);
  for (int j = 0; j < size[1]; ++j) {
    auto* line = reinterpret_cast<QRgb*>(slice.scanLine(upsideDown ? size[1] - 1 - j : j));
    for (int i = 0; i < size[0]; ++i) {
      const int gray = softTissue.grey(ct.at(i, j, k));
      const std::uint8_t label = read.labels.at(i, j, k);
      LabelColour shown{};
      shown.fill(std::uint8_t(gray));
      if (label != 0) {
        const LabelColour colour = colourOf(read.colours, label);
        for (int c = 0; c < 3; ++c) shown[c] = std::uint8_t((gray + colour[c]) / 2);
      }
      line[mirrored ? size[0] - 1 - i : i] = qRgb(shown[0], shown[1], shown[2]);
    }
  }
  const double width_mm = size[0] * ct.geometry.spacing_mm.x, height_mm = size[1] * ct.geometry.spacing_mm.y;
  const double scale = side / std::max(width_mm, height_mm);
  return slice.scaled(std::max(1, int(std::lround(width_mm * scale))), std::max(1, int(std::lround(height_mm * scale))),
                      Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

LabelsDialog::LabelsDialog(const QString& fileName, const CtVolume& ct, const LabelReadResult& read, QWidget* parent)
    : QDialog(parent), replace_(new QPushButton(tr("Replace labels"))) {
  setWindowTitle(tr("Import labels"));
  auto* title = new QLabel(tr("Labels of %1").arg(fileName));
  title->setTextFormat(Qt::PlainText);
  setRole(title, "title");
  auto* about = new QLabel(tr("These structures replace the labels of the case. Compare names and places first."));
  about->setWordWrap(true);
  setRole(about, "quiet");
  auto* picture = new QLabel;
  picture->setObjectName(QStringLiteral("labelPreview"));
  picture->setPixmap(QPixmap::fromImage(labelPreview(ct, read, kPreview)));
  picture->setToolTip(tr("The slice with the most labeled voxels"));
  picture->setAccessibleName(picture->toolTip());
  picture->setAlignment(Qt::AlignTop);
  auto* row = new QHBoxLayout;
  row->setSpacing(kLargeGap);
  row->addWidget(mappingOf(read), 1);
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
  auto* warning = new QLabel(
      tr("The file does not say what its numbers mean, and each program numbers structures in its own way. The table "
         "shows what the numbers would be in Insonate."));
  warning->setWordWrap(true);
  areOurs_ = new QCheckBox(tr("The numbers are Insonate's"));
  areOurs_->setObjectName(QStringLiteral("numbersAreOurs"));
  areOurs_->setToolTip(tr("Only for label maps that were written with Insonate's label numbers"));
  auto* names = new QPushButton(tr("Names from a file ..."));
  names->setObjectName(QStringLiteral("nameNumbers"));
  names->setToolTip(
      tr("A label description of ITK-SNAP, a color table of 3D Slicer (.ctbl), or a JSON file of dcmqi or nnU-Net"));
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
    Q_EMIT namesWanted();
  });
}

}  // namespace insonate::ui
