#include <insonate/image/VoxelBox.h>

#include <algorithm>
#include <cmath>

namespace insonate {

std::array<int, 3> nearestVoxel(Vec3 index) {
  return {static_cast<int>(std::floor(index.x + 0.5)), static_cast<int>(std::floor(index.y + 0.5)),
          static_cast<int>(std::floor(index.z + 0.5))};
}

VoxelBox boxOf(const VolumeGeometry& geometry) {
  return {{0, 0, 0}, geometry.size};
}

VoxelBox intersected(const VoxelBox& a, const VoxelBox& b) {
  VoxelBox both;
  for (int axis = 0; axis < 3; ++axis) {
    both.first[axis] = std::max(a.first[axis], b.first[axis]);
    both.end[axis] = std::min(a.end[axis], b.end[axis]);
  }
  return both.empty() ? VoxelBox{} : both;
}

VoxelBox united(const VoxelBox& a, const VoxelBox& b) {
  if (a.empty() || b.empty()) return a.empty() ? b : a;
  VoxelBox either;
  for (int axis = 0; axis < 3; ++axis) {
    either.first[axis] = std::min(a.first[axis], b.first[axis]);
    either.end[axis] = std::max(a.end[axis], b.end[axis]);
  }
  return either;
}

VoxelBox boxAround(const VolumeGeometry& geometry, std::span<const Vec3> points_mm, double radius_mm) {
  const Transform indexFromPatient = geometry.indexFromPatient();
  VoxelBox box;
  for (const Vec3& point_mm : points_mm) {
    const Vec3 index = indexFromPatient * point_mm;
    VoxelBox ball;
    for (int axis = 0; axis < 3; ++axis) {
      // The index of a distant point would not fit into an int.
      const double reach = radius_mm / geometry.spacing_mm[axis], size = geometry.size[axis];
      ball.first[axis] = static_cast<int>(std::clamp(std::ceil(index[axis] - reach), 0.0, size));
      ball.end[axis] = static_cast<int>(std::clamp(std::floor(index[axis] + reach) + 1, 0.0, size));
    }
    box = united(box, ball.empty() ? VoxelBox{} : ball);
  }
  return box;
}

VoxelBox grown(const VoxelBox& box, const VolumeGeometry& geometry, double margin_mm) {
  if (box.empty()) return box;
  VoxelBox larger;
  for (int axis = 0; axis < 3; ++axis) {
    const int margin = static_cast<int>(std::min(std::ceil(margin_mm / geometry.spacing_mm[axis]), 1e6));
    larger.first[axis] = std::max(0, box.first[axis] - margin);
    larger.end[axis] = std::min(geometry.size[axis], box.end[axis] + margin);
  }
  return larger;
}

VolumeGeometry gridOf(const VolumeGeometry& geometry, const VoxelBox& box) {
  VolumeGeometry part = geometry;
  for (int axis = 0; axis < 3; ++axis) part.size[axis] = box.length(axis);
  part.origin_mm = geometry.patientFromIndex() * Vec3{double(box.first[0]), double(box.first[1]), double(box.first[2])};
  return part;
}

}  // namespace insonate
