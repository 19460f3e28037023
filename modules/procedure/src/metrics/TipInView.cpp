#include <insonate/procedure/TipInView.h>

#include <cmath>
#include <numbers>

namespace insonate {

double maxOffPlane_mm(const ImageField& field, double range_mm) {
  const double off_mm = range_mm - field.elevationFocus_mm;
  const double growth = off_mm < 0 ? field.elevationDivergence : field.elevationDivergenceBehind;
  return std::hypot(2 * field.sliceHalf_mm, growth * off_mm);
}

bool isTipInView(const ImageField& field, double depth_mm, Vec3 tip_probe) {
  const auto [x, y, z] = tip_probe;
  const bool isFan = field.fanAngle_deg > 0;
  const double range_mm = isFan ? std::hypot(x, z + field.faceRadius_mm) - field.faceRadius_mm : z;
  if (range_mm < 0 || range_mm > depth_mm || std::abs(y) > maxOffPlane_mm(field, range_mm)) return false;
  if (!isFan) return std::abs(x) <= field.width_mm / 2;
  return std::abs(std::atan2(x, z + field.faceRadius_mm)) * 180 / std::numbers::pi <= field.fanAngle_deg / 2;
}

}  // namespace insonate
