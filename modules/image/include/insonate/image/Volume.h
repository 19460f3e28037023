#pragma once

#include <insonate/image/VolumeGeometry.h>

#include <cstdint>
#include <vector>

namespace insonate {

/// Voxels on a grid in patient space. Voxels with consecutive i (first index) are adjacent in memory. The volume owns
/// its voxels.
template <class T>
struct Volume {
  VolumeGeometry geometry;
  std::vector<T> voxels;

  Volume() = default;
  explicit Volume(const VolumeGeometry& g, T fill = T{}) : geometry(g), voxels(g.voxelCount(), fill) {}

  T& at(int i, int j, int k) { return voxels[geometry.offset(i, j, k)]; }
  const T& at(int i, int j, int k) const { return voxels[geometry.offset(i, j, k)]; }
};

/// CT in Hounsfield units.
using CtVolume = Volume<std::int16_t>;
/// Label of each voxel, as in insonate/tissue/Labels.h; 0: outside the patient.
using LabelMap = Volume<std::uint8_t>;

/// Returns the trilinearly interpolated value at a continuous index (voxel centers at integers); outside the grid, the
/// value of the nearest edge voxel.
double sampleLinear(const CtVolume& volume, Vec3 index);
/// Returns the value of the nearest voxel; `outside` if the index is more than half a voxel beyond the grid.
std::uint8_t sampleNearest(const LabelMap& labels, Vec3 index, std::uint8_t outside = 0);

}  // namespace insonate
