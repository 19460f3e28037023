#include "model/PlaneShift.h"

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

constexpr double kTolerance_mm = 1e-4;
constexpr int kSteps = 30, kHalvings = 8;

struct Interval {
  int low, high;
  double fraction;
};

Interval intervalAt(double position, int points) {
  const double at = std::clamp(position, 0.0, points - 1.0);
  const int low = std::min(static_cast<int>(at), std::max(points - 2, 0));
  return {low, std::min(low + 1, points - 1), at - low};
}

}  // namespace

Vec3 shiftAt(const PlaneDisplacement& displacement, double x_mm, double z_mm) {
  if (displacement.empty()) return {};
  const Interval i = intervalAt((x_mm - displacement.left_mm) / displacement.step_mm, displacement.columns);
  const Interval k = intervalAt((z_mm - displacement.top_mm) / displacement.step_mm, displacement.rows);
  const auto at = [&](int column, int row) {
    const auto& shift = displacement.restFromSeen[std::size_t(row) * displacement.columns + column];
    return Vec3{shift.x_mm, 0, shift.z_mm};
  };
  const auto along = [&](int row) { return at(i.low, row) * (1 - i.fraction) + at(i.high, row) * i.fraction; };
  return along(k.low) * (1 - k.fraction) + along(k.high) * k.fraction;
}

Vec3 seenFromRest(const PlaneDisplacement& displacement, Vec3 rest_mm) {
  if (displacement.empty()) return rest_mm;
  const auto missOf = [&](Vec3 seen) {
    const Vec3 miss = rest_mm - seen - shiftAt(displacement, seen.x, seen.z);
    return Vec3{miss.x, 0, miss.z};
  };
  const double probe_mm = 0.25 * displacement.step_mm;  // of the differences that stand for slopes
  Vec3 seen = rest_mm - shiftAt(displacement, rest_mm.x, rest_mm.z), miss = missOf(seen);
  for (int step = 0; step < kSteps && norm(miss) > kTolerance_mm; ++step) {
    const auto slope = [&](Vec3 along) {
      const Vec3 a = shiftAt(displacement, seen.x + along.x, seen.z + along.z);
      const Vec3 b = shiftAt(displacement, seen.x - along.x, seen.z - along.z);
      return (a - b) / (2 * probe_mm);
    };
    const Vec3 byX = slope({probe_mm, 0, 0}) + Vec3{1, 0, 0}, byZ = slope({0, 0, probe_mm}) + Vec3{0, 0, 1};
    const double determinant = byX.x * byZ.z - byX.z * byZ.x;
    Vec3 way = miss;
    if (std::abs(determinant) > 1e-3)
      way = {(miss.x * byZ.z - miss.z * byZ.x) / determinant, 0, (miss.z * byX.x - miss.x * byX.z) / determinant};
    // Across the edges of cells slopes change: go no farther than it helps.
    Vec3 next = seen + way, nextMiss = missOf(next);
    for (int halving = 0; halving < kHalvings && norm(nextMiss) >= norm(miss); ++halving) {
      way = way * 0.5;
      next = seen + way, nextMiss = missOf(next);
    }
    seen = next, miss = nextMiss;
  }
  return seen;
}

}  // namespace insonate
