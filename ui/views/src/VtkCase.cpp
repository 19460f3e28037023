#include <insonate/views/VtkCase.h>

#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkPointData.h>
#include <vtkShortArray.h>

namespace insonate::views {
namespace {

/// A view that has missed more changes than this is redrawn completely.
constexpr std::size_t kChangesKept = 64;

void point(vtkShortArray& voxels, const CtVolume& ct) {
  // VTK has no arrays of constants; this code does not write to the array.
  voxels.SetArray(const_cast<std::int16_t*>(ct.voxels.data()), static_cast<vtkIdType>(ct.voxels.size()), 1);
  voxels.Modified();
}

vtkSmartPointer<vtkImageData> wrapped(const CtVolume& ct) {
  auto image = vtkSmartPointer<vtkImageData>::New();
  const VolumeGeometry& grid = ct.geometry;
  image->SetDimensions(grid.size[0], grid.size[1], grid.size[2]);
  image->SetSpacing(grid.spacing_mm.x, grid.spacing_mm.y, grid.spacing_mm.z);
  image->SetOrigin(grid.origin_mm.x, grid.origin_mm.y, grid.origin_mm.z);
  const auto& axis = grid.direction.column;
  const double rows[9] = {axis[0].x, axis[1].x, axis[2].x, axis[0].y, axis[1].y,
                          axis[2].y, axis[0].z, axis[1].z, axis[2].z};
  image->SetDirectionMatrix(rows);
  auto voxels = vtkSmartPointer<vtkShortArray>::New();
  point(*voxels, ct);
  image->GetPointData()->SetScalars(voxels);
  return image;
}

}  // namespace

VtkCase::VtkCase(std::shared_ptr<const PatientCase> patient)
    : patient_(std::move(patient)), ct_(wrapped(patient_->ct)), changes_{{1, boxOf(patient_->labels.geometry)}} {}
VtkCase::~VtkCase() = default;

bool VtkCase::setPatient(std::shared_ptr<const PatientCase> patient) {
  if (patient->ct.geometry != patient_->ct.geometry || patient->ct.voxels.size() != patient_->ct.voxels.size())
    return false;
  // The same array, which others hold, too.
  point(*vtkShortArray::SafeDownCast(ct_->GetPointData()->GetScalars()), patient->ct);
  patient_ = std::move(patient);
  labelsChanged();
  return true;
}

vtkImageData* VtkCase::ct() const {
  return ct_;
}

void VtkCase::labelsChanged(const VoxelBox& box) {
  changes_.push_back({labelRevision() + 1, box});
  if (changes_.size() > kChangesKept) changes_.pop_front();
}

VoxelBox VtkCase::changedSince(std::uint64_t revision) const {
  if (revision + 1 < changes_.front().revision) return boxOf(patient_->labels.geometry);
  VoxelBox all;
  for (const Change& change : changes_)
    if (change.revision > revision) all = united(all, change.box);
  return all;
}

void VtkCase::setLabels(std::shared_ptr<const LabelMap> labels) {
  instead_ = std::move(labels);
  labelsChanged();
}

vtkSmartPointer<vtkMatrix4x4> vtkMatrix(const Transform& transform) {
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) matrix->SetElement(row, column, transform.linear.column[column][row]);
    matrix->SetElement(row, 3, transform.offset[row]);
  }
  return matrix;
}

}  // namespace insonate::views
