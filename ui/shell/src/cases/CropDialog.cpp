#include "CropDialog.h"

#include "../controls/NumberBox.h"

#include <insonate/ui/Text.h>
#include <insonate/ui/Theme.h>
#include <insonate/views/SlicePlane.h>

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <utility>

namespace insonate::ui {
namespace {

/// Range of patient coordinates of a grid, to the centers of its outermost voxels.
PatientBox reachOf(const VolumeGeometry& g) {
  PatientBox reach{g.origin_mm, g.origin_mm};
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p = g.patientFromIndex() * Vec3{corner & 1 ? g.size[0] - 1.0 : 0, corner & 2 ? g.size[1] - 1.0 : 0,
                                               corner & 4 ? g.size[2] - 1.0 : 0};
    for (int a = 0; a < 3; ++a) {
      reach.low_mm[a] = std::min(reach.low_mm[a], p[a]);
      reach.high_mm[a] = std::max(reach.high_mm[a], p[a]);
    }
  }
  for (int a = 0; a < 3; ++a) {
    // A margin of a tenth of a millimeter, so that rounding cuts no voxel off.
    reach.low_mm[a] = std::floor(reach.low_mm[a] * 10) / 10;
    reach.high_mm[a] = std::ceil(reach.high_mm[a] * 10) / 10;
  }
  return reach;
}

QString textOf(const VolumeGeometry& g) {
  return CropDialog::tr("%1 x %2 x %3 voxels").arg(g.size[0]).arg(g.size[1]).arg(g.size[2]);
}

/// Names of the patient directions, the first three axes of LPS.
QString directionWords(int axis) {
  const QString words[] = {CropDialog::tr("right to left"), CropDialog::tr("front to back"),
                           CropDialog::tr("feet to head")};
  return words[axis];
}

/// Patient direction of a grid's axis; for oblique ones, for example "RA to LP".
QString directionOf(Vec3 axis) {
  const std::string to = views::orientationLetters(axis);
  if (to.size() > 1) return CropDialog::tr("%1 to %2").arg(qt(views::orientationLetters(-axis)), qt(to));
  return directionWords(to == "L" || to == "R" ? 0 : to == "P" || to == "A" ? 1 : 2);
}

QLabel* headingOf(const QString& words) {
  auto* label = new QLabel(words);
  setRole(label, "quiet");
  return label;
}

}  // namespace

CropDialog::CropDialog(std::shared_ptr<const PatientCase> patient, QWidget* parent)
    : QDialog(parent),
      geometry_(patient->ct.geometry),
      views_(new CropViews(std::move(patient), reachOf(geometry_))),
      resample_(new QCheckBox(tr("Change voxel spacing"))),
      result_(new QLabel),
      crop_(new QPushButton(tr("Crop"))) {
  setWindowTitle(tr("Crop and resample"));
  auto* title = new QLabel(tr("Part of the case to keep"));
  setRole(title, "title");
  auto* about =
      new QLabel(tr("Crops CT and labels together; targets and start poses do not move. The open case stays unchanged "
                    "on disk; the cropped part is saved as a new case. A CT without arms and table is faster and needs "
                    "less memory: drag the box to the neck."));
  about->setWordWrap(true);
  setRole(about, "quiet");
  auto* grid = new QGridLayout;
  grid->setSpacing(kGap);
  addRegion(*grid);
  addSpacing(*grid);
  result_->setWordWrap(true);
  result_->setObjectName(QStringLiteral("cropResult"));
  setRole(crop_, "primary");
  crop_->setDefault(true);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
  buttons->addButton(crop_, QDialogButtonBox::AcceptRole);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(kLargeGap, kLargeGap, kLargeGap, kLargeGap);
  box->setSpacing(kGap);
  box->addWidget(title);
  box->addWidget(about);
  box->addWidget(views_, 1);
  box->addLayout(grid);
  box->addWidget(result_);
  box->addWidget(buttons);
  resize(900, 640);
  connect(views_, &CropViews::boxChanged, this, &CropDialog::takeBox);
  refresh();
}

QDoubleSpinBox* CropDialog::field(const QString& name, double least, double most, int decimals) {
  auto* box = new NumberBox<QDoubleSpinBox>(name);
  box->setDecimals(decimals);
  box->setRange(least, most);
  box->setSuffix(tr(" mm"));
  box->setAccessibleName(name);
  box->setToolTip(name);
  connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &CropDialog::refresh);
  return box;
}

void CropDialog::addRegion(QGridLayout& grid) {
  const PatientBox& limits = views_->box();
  grid.addWidget(headingOf(tr("from")), 0, 1);
  grid.addWidget(headingOf(tr("to")), 0, 2);
  for (int a = 0; a < 3; ++a) {
    const double least = limits.low_mm[a], most = limits.high_mm[a];
    from_[a] = field(tr("From, %1").arg(directionWords(a)), least, most, 1);
    to_[a] = field(tr("To, %1").arg(directionWords(a)), least, most, 1);
    from_[a]->setValue(least);
    to_[a]->setValue(most);
    grid.addWidget(new QLabel(directionWords(a)), a + 1, 0);
    grid.addWidget(from_[a], a + 1, 1);
    grid.addWidget(to_[a], a + 1, 2);
  }
}

void CropDialog::addSpacing(QGridLayout& grid) {
  resample_->setToolTip(tr("Coarser voxel spacing takes less memory and time; finer voxel spacing adds no detail"));
  grid.addWidget(resample_, 4, 0, 1, 3);
  for (int a = 0; a < 3; ++a) {
    const QString direction = directionOf(geometry_.direction.column[a]);
    spacing_[a] = field(tr("Spacing, %1").arg(direction), 0.05, 25, 3);
    spacing_[a]->setSingleStep(0.1);
    spacing_[a]->setValue(geometry_.spacing_mm[a]);
    rounded_mm_[a] = spacing_[a]->value();
    spacing_[a]->setEnabled(false);
    QLabel* name = headingOf(direction);
    name->setBuddy(spacing_[a]);
    grid.addWidget(name, 5, a);
    grid.addWidget(spacing_[a], 6, a);
    connect(resample_, &QCheckBox::toggled, spacing_[a], &QWidget::setEnabled);
  }
  connect(resample_, &QCheckBox::toggled, this, &CropDialog::refresh);
}

CropOptions CropDialog::options() const {
  const auto values = [](const std::array<QDoubleSpinBox*, 3>& fields) {
    return Vec3{fields[0]->value(), fields[1]->value(), fields[2]->value()};
  };
  CropOptions options{boxBetween(geometry_, values(from_), values(to_)), {}};
  if (resample_->isChecked()) {
    options.spacing_mm = values(spacing_);
    // A field that the user did not change has a rounded number, which would resample, and blur, that axis, too.
    for (int a = 0; a < 3; ++a)
      if ((*options.spacing_mm)[a] == rounded_mm_[a]) (*options.spacing_mm)[a] = geometry_.spacing_mm[a];
  }
  return options;
}

void CropDialog::takeBox() {
  const PatientBox box = views_->box();
  for (int a = 0; a < 3; ++a) {
    const QSignalBlocker from(from_[a]), to(to_[a]);
    from_[a]->setValue(box.low_mm[a]);
    to_[a]->setValue(box.high_mm[a]);
  }
  refresh();
}

void CropDialog::refresh() {
  if (!spacing_[2]) return;  // the fields do not exist yet
  PatientBox box;
  for (int a = 0; a < 3; ++a) {
    box.low_mm[a] = std::min(from_[a]->value(), to_[a]->value());
    box.high_mm[a] = std::max(from_[a]->value(), to_[a]->value());
  }
  views_->setBox(box);
  const auto grid = croppedGrid(geometry_, options());
  crop_->setEnabled(grid.has_value());
  if (!grid) return result_->setText(QString::fromStdString(grid.error().message));
  constexpr double kBytes = 3, kMega = 1e6;  // of a voxel: CT value and label
  result_->setText(tr("Size now: %1. Size of the new case: %2, %3 MB.")
                       .arg(textOf(geometry_), textOf(*grid))
                       .arg(double(grid->voxelCount()) * kBytes / kMega, 0, 'f', 1));
}

}  // namespace insonate::ui
