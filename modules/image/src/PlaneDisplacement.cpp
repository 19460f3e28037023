#include <insonate/image/PlaneDisplacement.h>

#include <algorithm>
#include <cstddef>

namespace insonate {
namespace {

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

}  // namespace insonate
