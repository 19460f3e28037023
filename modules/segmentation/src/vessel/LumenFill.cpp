#include "LumenFill.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace insonate::segmentation {
namespace {

double largest_mm(const VesselOutline& outline) {
  return *std::ranges::max_element(outline.radius_mm);
}

double radiusAt(const VesselOutline& outline, double angle) {
  double ray = angle / (2 * std::numbers::pi) * VesselOutline::kRays;
  ray -= VesselOutline::kRays * std::floor(ray / VesselOutline::kRays);
  const int n = static_cast<int>(ray) % VesselOutline::kRays;
  const double share = ray - std::floor(ray);
  return outline.radius_mm[n] * (1 - share) + outline.radius_mm[(n + 1) % VesselOutline::kRays] * share;
}

/// Interpolates between two sections, which need not be parallel, by the distances of a point from both planes.
bool between(const VesselOutline& a, const VesselOutline& b, Vec3 point_mm) {
  const double behindA = dot(point_mm - a.center_mm, cross(a.right, a.down));
  const double beforeB = -dot(point_mm - b.center_mm, cross(b.right, b.down));
  if (behindA < 0 || beforeB < 0 || behindA + beforeB <= 0) return false;
  const double t = behindA / (behindA + beforeB);
  const Vec3 off = point_mm - (a.center_mm * (1 - t) + b.center_mm * t);
  const Vec3 right = a.right * (1 - t) + b.right * t, down = a.down * (1 - t) + b.down * t;
  const double x = dot(off, right), y = dot(off, down), angle = std::atan2(y, x);
  return std::hypot(x, y) <= radiusAt(a, angle) * (1 - t) + radiusAt(b, angle) * t;
}

}  // namespace

Selection fillLumen(const VolumeGeometry& geometry, std::span<const VesselOutline> outlines) {
  const auto boxOfPair = [&](std::size_t n) {
    const std::array ends{outlines[n].center_mm, outlines[n + 1].center_mm};
    return boxAround(geometry, ends, std::max(largest_mm(outlines[n]), largest_mm(outlines[n + 1])) + 1);
  };
  VoxelBox all;
  for (std::size_t n = 0; n + 1 < outlines.size(); ++n) all = united(all, boxOfPair(n));
  Selection lumen(geometry, all);
  const Transform patientFromIndex = geometry.patientFromIndex();
  for (std::size_t n = 0; n + 1 < outlines.size(); ++n) {
    const VoxelBox box = boxOfPair(n);
    for (int k = box.first[2]; k < box.end[2]; ++k)
      for (int j = box.first[1]; j < box.end[1]; ++j)
        for (int i = box.first[0]; i < box.end[0]; ++i)
          if (between(outlines[n], outlines[n + 1], patientFromIndex * Vec3{double(i), double(j), double(k)}))
            lumen.mask.at(i - all.first[0], j - all.first[1], k - all.first[2]) = 1;
  }
  return lumen;
}

}  // namespace insonate::segmentation
