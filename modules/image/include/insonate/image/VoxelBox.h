#pragma once

#include <insonate/image/Volume.h>

#include <array>
#include <span>

namespace insonate {

/// A block of a grid's voxels: indices from `first` up to, but not including, `end` along i, j, k. The block is empty
/// unless `end` is above `first` on every axis.
struct VoxelBox {
  std::array<int, 3> first{}, end{};

  bool operator==(const VoxelBox&) const = default;

  bool empty() const { return first[0] >= end[0] || first[1] >= end[1] || first[2] >= end[2]; }
  int length(int axis) const { return end[axis] - first[axis]; }
  bool contains(int i, int j, int k) const {
    return i >= first[0] && j >= first[1] && k >= first[2] && i < end[0] && j < end[1] && k < end[2];
  }
};

/// Returns the voxel whose center is nearest to a continuous index; the voxel may lie outside the grid. The index must
/// be within the range of int.
std::array<int, 3> nearestVoxel(Vec3 index);

/// Returns the box of a whole grid.
VoxelBox boxOf(const VolumeGeometry& geometry);
/// Returns the intersection of two boxes.
VoxelBox intersected(const VoxelBox& a, const VoxelBox& b);
/// Returns the smallest box around both boxes; an empty box is ignored.
VoxelBox united(const VoxelBox& a, const VoxelBox& b);
/// Returns the smallest box of voxels within the grid that contains a ball of this radius around each point (patient
/// space).
VoxelBox boxAround(const VolumeGeometry& geometry, std::span<const Vec3> points_mm, double radius_mm);
/// Returns the box enlarged on all sides by `margin_mm`, rounded up to whole voxels, and limited to the grid.
VoxelBox grown(const VoxelBox& box, const VolumeGeometry& geometry, double margin_mm);

/// Returns the grid of a block of a larger grid. Voxels keep their positions in the patient. The block must not be
/// empty.
VolumeGeometry gridOf(const VolumeGeometry& geometry, const VoxelBox& box);

/// Copies a block of a volume. The block must not be empty and must lie within the volume.
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
