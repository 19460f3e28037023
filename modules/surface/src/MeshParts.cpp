#include "MeshParts.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace insonate {
namespace {

using PointNumbers = std::vector<std::uint32_t>;

std::uint32_t rootOf(PointNumbers& parent, std::uint32_t point) {
  while (parent[point] != point) point = parent[point] = parent[parent[point]];
  return point;
}

/// Maps each point to the representative point of its connected part.
PointNumbers partsOf(const Mesh& mesh) {
  PointNumbers parent(mesh.pointCount());
  std::iota(parent.begin(), parent.end(), 0U);
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3)
    for (int c = 1; c < 3; ++c) {
      const std::uint32_t a = rootOf(parent, mesh.triangles[t]), b = rootOf(parent, mesh.triangles[t + c]);
      parent[std::max(a, b)] = std::min(a, b);
    }
  for (std::uint32_t p = 0; p < parent.size(); ++p) parent[p] = rootOf(parent, p);
  return parent;
}

/// Six times the volume of each part, stored at its representative; negative for a cavity.
std::vector<double> volumesOf(const Mesh& mesh, const std::vector<float>& points_mm, const PointNumbers& part) {
  std::vector<double> volumes(part.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    const std::uint32_t at = part[mesh.triangles[t]];
    // Relative to a point of the part: relative to the scanner's origin, rounding would exceed the volume of small
    // parts.
    const Vec3 from = pointOf(mesh.points_mm, at);
    const Vec3 a = pointOf(points_mm, mesh.triangles[t]) - from, b = pointOf(points_mm, mesh.triangles[t + 1]) - from;
    volumes[at] += dot(a, cross(b, pointOf(points_mm, mesh.triangles[t + 2]) - from));
  }
  return volumes;
}

}  // namespace

void keepSmallParts(const Mesh& mesh, std::vector<float>& moved_mm, double volumeKept) {
  const PointNumbers part = partsOf(mesh);
  const std::vector<double> before = volumesOf(mesh, mesh.points_mm, part);
  const std::vector<float> farthest = moved_mm;
  for (const float way : {0.75F, 0.5F, 0.25F, 0.F}) {
    const std::vector<double> after = volumesOf(mesh, moved_mm, part);
    bool drawn = false;
    for (std::size_t p = 0; p < part.size(); ++p) {
      if (after[part[p]] * std::copysign(1, before[part[p]]) >= volumeKept * std::abs(before[part[p]])) continue;
      drawn = true;
      for (std::size_t a = 3 * p; a < 3 * p + 3; ++a)
        moved_mm[a] = mesh.points_mm[a] + way * (farthest[a] - mesh.points_mm[a]);
    }
    if (!drawn) return;
  }
}

void restoreVolume(Mesh& mesh, double target_mm3, double limit_mm) {
  const std::vector<float> start = mesh.points_mm, normals = pointNormals(mesh);
  double way_mm = 0;
  // Newton's steps: the area is the derivative of the volume. After three, the error is below a thousandth, except for
  // tiny parts.
  for (int step = 0; step < 3; ++step) {
    const double area = area_mm2(mesh);
    if (!(area > 0)) return;
    way_mm = std::clamp(way_mm + (target_mm3 - volume_mm3(mesh)) / area, -limit_mm, limit_mm);
    for (std::size_t c = 0; c < start.size(); ++c)
      mesh.points_mm[c] = start[c] + static_cast<float>(way_mm) * normals[c];
  }
}

std::vector<float> pointNormals(const Mesh& mesh) {
  std::vector<Vec3> sums(mesh.pointCount());
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    const std::uint32_t* corner = &mesh.triangles[t];
    const Vec3 a = pointOf(mesh.points_mm, corner[0]);
    const Vec3 twiceArea = cross(pointOf(mesh.points_mm, corner[1]) - a, pointOf(mesh.points_mm, corner[2]) - a);
    for (int c = 0; c < 3; ++c) sums[corner[c]] = sums[corner[c]] + twiceArea;
  }
  std::vector<float> normals;
  normals.reserve(mesh.points_mm.size());
  for (const Vec3& sum : sums) {
    const double length = norm(sum);
    const Vec3 normal = length > 0 ? sum / length : Vec3{0, 0, 1};  // any direction is acceptable if all triangles are
                                                                    // degenerate
    for (int a = 0; a < 3; ++a) normals.push_back(static_cast<float>(normal[a]));
  }
  return normals;
}

}  // namespace insonate
