#include <insonate/segmentation/Brush.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace insonate {
namespace {

/// A stroke in millimeters along the grid's axes; flat if the brush is a circle.
struct Stroke {
  std::vector<Vec3> points;
  Vec3 spacing_mm;
  int slice = 0;

  Stroke(const VolumeGeometry& g, std::span<const Vec3> stroke_mm, std::optional<int> sliceAxis)
      : spacing_mm(g.spacing_mm) {
    const Transform indexFromPatient = g.indexFromPatient();
    for (const Vec3& point_mm : stroke_mm) {
      Vec3 p = indexFromPatient * point_mm;
      if (sliceAxis) {
        if (points.empty()) slice = static_cast<int>(std::clamp(std::floor(p[*sliceAxis] + 0.5), -1.0, 1e9));
        p[*sliceAxis] = slice;
      }
      points.push_back(scaled(p));
    }
  }
  Vec3 scaled(Vec3 index) const { return {index.x * spacing_mm.x, index.y * spacing_mm.y, index.z * spacing_mm.z}; }
};

/// Box of the voxels that a ball around two points of a stroke may reach.
VoxelBox reachOf(const VolumeGeometry& g, Vec3 a, Vec3 b, double radius_mm) {
  VoxelBox box;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = (std::min(a[axis], b[axis]) - radius_mm) / g.spacing_mm[axis];
    const double high = (std::max(a[axis], b[axis]) + radius_mm) / g.spacing_mm[axis];
    const double size = g.size[axis];
    box.first[axis] = static_cast<int>(std::clamp(std::ceil(low), 0.0, size));
    box.end[axis] = static_cast<int>(std::clamp(std::floor(high) + 1, 0.0, size));
  }
  return box.empty() ? VoxelBox{} : box;
}

void paintSegment(Selection& chosen, const VoxelBox& box, const Stroke& stroke, Vec3 a, Vec3 b, double radius_mm) {
  const Vec3 way = b - a;
  const double length2 = dot(way, way);
  for (int k = box.first[2]; k < box.end[2]; ++k)
    for (int j = box.first[1]; j < box.end[1]; ++j) {
      std::uint8_t* const row = &chosen.mask.at(0, j - chosen.box.first[1], k - chosen.box.first[2]);
      for (int i = box.first[0]; i < box.end[0]; ++i) {
        const Vec3 off = stroke.scaled({double(i), double(j), double(k)}) - a;
        const double along = length2 > 0 ? std::clamp(dot(off, way) / length2, 0.0, 1.0) : 0;
        const Vec3 rest = off - way * along;
        if (dot(rest, rest) <= radius_mm * radius_mm) row[i - chosen.box.first[0]] = 1;
      }
    }
}

}  // namespace

Selection strokeVoxels(const VolumeGeometry& geometry, std::span<const Vec3> stroke_mm, const Brush& brush) {
  const Stroke stroke(geometry, stroke_mm, brush.sliceAxis);
  const auto& points = stroke.points;
  const auto segmentBox = [&](std::size_t n) {
    VoxelBox box = reachOf(geometry, points[n], points[std::min(n + 1, points.size() - 1)], brush.radius_mm);
    if (brush.sliceAxis) {
      VoxelBox slice = boxOf(geometry);
      slice.first[*brush.sliceAxis] = stroke.slice, slice.end[*brush.sliceAxis] = stroke.slice + 1;
      box = intersected(box, slice);
    }
    return box;
  };
  const auto nearest = [&](std::size_t n) {
    VoxelBox one;
    for (int axis = 0; axis < 3; ++axis) {
      const double index = std::floor(points[n][axis] / geometry.spacing_mm[axis] + 0.5);
      if (!(index >= 0 && index < geometry.size[axis])) return VoxelBox{};
      one.first[axis] = static_cast<int>(index), one.end[axis] = one.first[axis] + 1;
    }
    return one;
  };
  VoxelBox all;
  for (std::size_t n = 0; n < points.size(); ++n) all = united(united(all, segmentBox(n)), nearest(n));
  Selection chosen(geometry, all);
  for (std::size_t n = 0; n < points.size(); ++n) {
    if (n + 1 < points.size() || n == 0)
      paintSegment(chosen, segmentBox(n), stroke, points[n], points[std::min(n + 1, points.size() - 1)],
                   brush.radius_mm);
    if (const VoxelBox one = nearest(n); !one.empty())
      chosen.mask.at(one.first[0] - all.first[0], one.first[1] - all.first[1], one.first[2] - all.first[2]) = 1;
  }
  return chosen;
}

}  // namespace insonate
