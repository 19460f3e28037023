#pragma once

#include <insonate/image/Volume.h>

#include <array>
#include <span>

namespace insonate {

/// A block of a grid's voxels: first to end along i, j, k, the end not among them. Empty unless every end is above its
/// first.
struct VoxelBox {
  std::array<int, 3> first{}, end{};

  bool operator==(const VoxelBox&) const = default;

  bool empty() const { return first[0] >= end[0] || first[1] >= end[1] || first[2] >= end[2]; }
  int length(int axis) const { return end[axis] - first[axis]; }
  bool contains(int i, int j, int k) const {
    return i >= first[0] && j >= first[1] && k >= first[2] && i < end[0] && j < end[1] && k < end[2];
  }
};

/// The voxel whose center is nearest to a continuous index that is not far beyond a grid.
std::array<int, 3> nearestVoxel(Vec3 index);

/// Box of a whole grid.
VoxelBox boxOf(const VolumeGeometry& geometry);
/// Intersection of two boxes.
VoxelBox intersected(const VoxelBox& a, const VoxelBox& b);
/// The smallest box around both; an empty one does not count.
VoxelBox united(const VoxelBox& a, const VoxelBox& b);
/// The voxels that a ball around any of these points reaches (patient, mm), and no more than the grid has.
VoxelBox boxAround(const VolumeGeometry& geometry, std::span<const Vec3> points_mm, double radius_mm);
/// Larger by as many voxels as `margin_mm` takes, within the grid.
VoxelBox grown(const VoxelBox& box, const VolumeGeometry& geometry, double margin_mm);

/// The grid of a block that is not empty: where its voxels lie in the patient.
VolumeGeometry gridOf(const VolumeGeometry& geometry, const VoxelBox& box);

/// A copy of a block that is not empty and lies in the volume.
template <class T>
Volume<T> cropped(const Volume<T>& volume, const VoxelBox& box) {
  Volume<T> part;
  part.geometry = gridOf(volume.geometry, box);
  part.voxels.reserve(part.geometry.voxelCount());
  for (int k = box.first[2]; k < box.end[2]; ++k)
    for (int j = box.first[1]; j < box.end[1]; ++j) {
      const T* row = volume.voxels.data() + volume.geometry.offset(box.first[0], j, k);
      part.voxels.insert(part.voxels.end(), row, row + box.length(0));
    }
  return part;
}

}  // namespace insonate
