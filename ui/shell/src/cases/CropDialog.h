#pragma once

#include "CropViews.h"

#include <insonate/cases/CropCase.h>

#include <QDialog>
#include <array>
#include <memory>

class QCheckBox;
class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QPushButton;

namespace insonate::ui {

/// Lets the user choose the region of a case to keep, by dragging a box in three slices or in mm in the patient's
/// frame, and its voxel spacing; shows the resulting size.
class CropDialog : public QDialog {
  Q_OBJECT

 public:
  CropDialog(std::shared_ptr<const PatientCase> patient, QWidget* parent);

  CropOptions options() const;

 private:
  QDoubleSpinBox* field(const QString& name, double least, double most, int decimals);
  void addRegion(QGridLayout& grid);
  void addSpacing(QGridLayout& grid);
  void takeBox();
  void refresh();

  VolumeGeometry geometry_;
  CropViews* views_;
  Vec3 rounded_mm_;  ///< the case's spacing, rounded as in the fields
  std::array<QDoubleSpinBox*, 3> from_{}, to_{}, spacing_{};
  QCheckBox* resample_;
  QLabel* result_;
  QPushButton* crop_;
};

}  // namespace insonate::ui
