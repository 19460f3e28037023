#include "model/PlaneShift.h"

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

constexpr double kTolerance_mm = 1e-4;
constexpr int kSteps = 30, kHalvings = 8;

}  // namespace

Vec3 seenFromRest(const PlaneDisplacement& displacement, Vec3 rest_mm) {
  if (displacement.empty()) return rest_mm;
  const auto missOf = [&](Vec3 seen) {
    const Vec3 miss = rest_mm - seen - shiftAt(displacement, seen.x, seen.z);
    return Vec3{miss.x, 0, miss.z};
  };
  const double probe_mm = 0.25 * displacement.step_mm;  // distance of the differences that approximate slopes
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
    // Slopes change at the edges of cells: stops where a step no longer reduces the error.
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
