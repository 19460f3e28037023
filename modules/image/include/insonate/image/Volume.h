#pragma once

#include <insonate/image/VolumeGeometry.h>

#include <cstdint>
#include <vector>

namespace insonate {

/// Voxels on a grid in patient space; i (first index) is fastest in memory. Owns its voxels.
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
/// Label of each voxel: a number of insonate/tissue/Labels.h; 0 is outside the patient.
using LabelMap = Volume<std::uint8_t>;

/// Interpolates trilinearly at a continuous index (voxel centers at integers); outside the grid, takes the nearest edge
/// voxel.
double sampleLinear(const CtVolume& volume, Vec3 index);
/// Returns the value of the nearest voxel; `outside` if the index is more than half a voxel beyond the grid.
std::uint8_t sampleNearest(const LabelMap& labels, Vec3 index, std::uint8_t outside = 0);

}  // namespace insonate
