#include "BlurProfile.h"

#include <cmath>
#include <numbers>

namespace insonate::camera {
namespace {

double normalDensity(double z) {
  return std::exp(-0.5 * z * z) * std::numbers::inv_sqrtpi / std::numbers::sqrt2;
}
double normalShare(double z) {
  return 0.5 * std::erfc(-z / std::numbers::sqrt2);
}
/// Integral of normalShare().
double integratedShare(double z) {
  return z * normalShare(z) + normalDensity(z);
}

BlurProfile::Edge edgeAt(double d, double sigma, double box) {
  constexpr double kShortBox = 0.3;
  if (box < kShortBox * sigma) {
    const double width = std::sqrt(sigma * sigma + box * box / 12), z = d / width;
    const double density = normalDensity(z) / width;
    return {float(normalShare(z)), float(density), float(-z * density * sigma / width)};
  }
  const double near = (d + box / 2) / sigma, far = (d - box / 2) / sigma;
  return {float(sigma / box * (integratedShare(near) - integratedShare(far))),
          float((normalShare(near) - normalShare(far)) / box), float((normalDensity(near) - normalDensity(far)) / box)};
}

}  // namespace

BlurProfile::BlurProfile(double sigma_mm, double box_mm)
    : reach_mm_(3.3 * sigma_mm + box_mm / 2), perEntry_(kEntries / (2 * reach_mm_)) {
  for (int i = 0; i < kEntries + 2; ++i) table_[std::size_t(i)] = edgeAt(i / perEntry_ - reach_mm_, sigma_mm, box_mm);
}

BlurProfile::Edge BlurProfile::at(double distance_mm) const {
  if (distance_mm <= -reach_mm_) return {};
  if (distance_mm >= reach_mm_) return {1, 0, 0};
  const double place = (distance_mm + reach_mm_) * perEntry_;
  const int i = int(place);
  const auto f = float(place - i);
  const Edge &a = table_[std::size_t(i)], &b = table_[std::size_t(i) + 1];
  return {a.share + f * (b.share - a.share), a.density + f * (b.density - a.density),
          a.byWidth + f * (b.byWidth - a.byWidth)};
}

}  // namespace insonate::camera
