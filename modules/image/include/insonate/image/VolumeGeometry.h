#pragma once

#include <insonate/core/Result.h>
#include <insonate/core/Transform.h>

#include <array>
#include <cstddef>

namespace insonate {

/// Position of a voxel grid in patient space (LPS, millimeters, as in DICOM).
struct VolumeGeometry {
  std::array<int, 3> size{1, 1, 1};  ///< number of voxels along i, j, k; each at least 1
  Vec3 spacing_mm{1, 1, 1};          ///< distance between neighboring voxel centers along i, j, k; each above 0
  Vec3 origin_mm{};                  ///< patient position of the center of voxel (0, 0, 0)
  Mat3 direction;                    ///< columns: patient directions of i, j, k; orthonormal (either handedness)

  bool operator==(const VolumeGeometry&) const = default;

  std::size_t voxelCount() const { return std::size_t(size[0]) * size[1] * size[2]; }
  std::size_t offset(int i, int j, int k) const { return (std::size_t(k) * size[1] + j) * size[0] + i; }
  bool contains(int i, int j, int k) const {
    return i >= 0 && j >= 0 && k >= 0 && i < size[0] && j < size[1] && k < size[2];
  }
  /// Maps a continuous voxel index (centers at integers) to patient LPS, mm.
  Transform patientFromIndex() const;
  Transform indexFromPatient() const;
  /// Returns the patient position of the center of the grid.
  Vec3 center_mm() const;
};

/// Tells whether two grids are equal within the rounding of file formats: their origins and far corners agree within a
/// tenth of a voxel.
bool sameGrid(const VolumeGeometry& a, const VolumeGeometry& b);

/// Fails with a sentence if sizes, spacings or directions cannot describe a grid.
Result<void> validate(const VolumeGeometry& geometry);

/// Fails if voxels are smaller than 0.05 mm or larger than 25 mm along an axis, which suggests a file in meters or
/// micrometers.
Result<void> checkVoxelSize(Vec3 spacing_mm);

}  // namespace insonate
