#include "Interval.h"

#include <insonate/image/PlaneDisplacement.h>

#include <cstddef>

namespace insonate {

Vec3 shiftAt(const PlaneDisplacement& displacement, double x_mm, double z_mm) {
  if (displacement.empty()) return {};
  const Interval i = intervalAt((x_mm - displacement.left_mm) / displacement.step_mm, displacement.columns);
  const Interval k = intervalAt((z_mm - displacement.top_mm) / displacement.step_mm, displacement.rows);
  const auto at = [&](int column, int row) {
    const auto& shift = displacement.restFromDisplayed[std::size_t(row) * displacement.columns + column];
    return Vec3{shift.x_mm, 0, shift.z_mm};
  };
  const auto along = [&](int row) { return at(i.low, row) * (1 - i.fraction) + at(i.high, row) * i.fraction; };
  return along(k.low) * (1 - k.fraction) + along(k.high) * k.fraction;
}

}  // namespace insonate
