#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/image/VoxelBox.h>

#include <vtkSmartPointer.h>

#include <cstdint>
#include <deque>
#include <memory>

class vtkImageData;
class vtkMatrix4x4;

namespace insonate::views {

/// A patient's volumes as VTK sees them, made once and shared among views. Wraps the patient's own voxels: no copy is
/// made, and the patient lives as long as this does. For the window's thread.
class VtkCase {
 public:
  explicit VtkCase(std::shared_ptr<const PatientCase> patient);
  ~VtkCase();

  const PatientCase& patient() const { return *patient_; }
  /// The patient, for readers on other threads.
  const std::shared_ptr<const PatientCase>& shared() const { return patient_; }
  /// Replaces the patient by the same voxels in other memory, for example a copy with another title. False for another
  /// grid, without a change.
  bool setPatient(std::shared_ptr<const PatientCase> patient);
  /// Hounsfield units; origin, spacing and direction of the patient's grid (LPS mm), oblique and left-handed ones too.
  vtkImageData* ct() const;

  /// The displayed labels: the patient's own, or another map instead, for example one that is being edited (same grid;
  /// null for the patient's own again). Do not write to them while a view renders.
  const LabelMap& labels() const { return instead_ ? *instead_ : patient_->labels; }
  void setLabels(std::shared_ptr<const LabelMap> labels);
  /// Say so after each change of voxels, and where they lie; then render the views.
  void labelsChanged(const VoxelBox& box);
  void labelsChanged() { labelsChanged(boxOf(patient_->labels.geometry)); }
  std::uint64_t labelRevision() const { return changes_.back().revision; }
  /// Holds every voxel that has changed after this revision.
  VoxelBox changedSince(std::uint64_t revision) const;

 private:
  std::shared_ptr<const PatientCase> patient_;
  std::shared_ptr<const LabelMap> instead_;
  vtkSmartPointer<vtkImageData> ct_;
  struct Change {
    std::uint64_t revision;
    VoxelBox box;
  };
  std::deque<Change> changes_;  ///< the latest; never empty
};

/// Row by row, for VTK.
vtkSmartPointer<vtkMatrix4x4> vtkMatrix(const Transform& transform);

}  // namespace insonate::views
