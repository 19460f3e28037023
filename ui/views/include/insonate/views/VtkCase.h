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

/// A patient's volumes as VTK data, made once and shared by several views. The object uses the patient's voxels without
/// a copy, and keeps the patient alive. May be used only on the window's thread.
class VtkCase {
 public:
  explicit VtkCase(std::shared_ptr<const PatientCase> patient);
  ~VtkCase();

  const PatientCase& patient() const { return *patient_; }
  /// Returns shared ownership of the patient, for use on other threads.
  const std::shared_ptr<const PatientCase>& shared() const { return patient_; }
  /// Replaces the patient by one with the same voxels at another address, for example a copy with another title.
  /// Returns false, without a change, if the grid differs.
  bool setPatient(std::shared_ptr<const PatientCase> patient);
  /// CT in Hounsfield units, with the origin, spacing and direction of the patient's grid (LPS, mm); oblique and
  /// left-handed grids are supported.
  vtkImageData* ct() const;

  /// Returns the displayed labels: the patient's, or the map that setLabels() has set. The labels must not be written
  /// while a view renders.
  const LabelMap& labels() const { return instead_ ? *instead_ : patient_->labels; }
  /// Sets a label map of the same grid to display in place of the patient's, for example one that is being edited;
  /// null: the patient's.
  void setLabels(std::shared_ptr<const LabelMap> labels);
  /// Call this after each change of labels within `box`, before the views are rendered.
  void labelsChanged(const VoxelBox& box);
  void labelsChanged() { labelsChanged(boxOf(patient_->labels.geometry)); }
  std::uint64_t labelRevision() const { return changes_.back().revision; }
  /// Returns a box that contains every voxel changed after this revision.
  VoxelBox changedSince(std::uint64_t revision) const;

 private:
  std::shared_ptr<const PatientCase> patient_;
  std::shared_ptr<const LabelMap> instead_;
  vtkSmartPointer<vtkImageData> ct_;
  struct Change {
    std::uint64_t revision;
    VoxelBox box;
  };
  std::deque<Change> changes_;  ///< latest last; never empty
};

/// Converts a transform to VTK's matrix, in row-major order.
vtkSmartPointer<vtkMatrix4x4> vtkMatrix(const Transform& transform);

}  // namespace insonate::views
