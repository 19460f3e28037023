#include "Interval.h"

#include <insonate/image/Volume.h>

#include <algorithm>
#include <cmath>

namespace insonate {

double sampleLinear(const CtVolume& volume, Vec3 index) {
  const auto& size = volume.geometry.size;
  const Interval x = intervalAt(index.x, size[0]), y = intervalAt(index.y, size[1]), z = intervalAt(index.z, size[2]);
  const auto row = [&](int j, int k) {
    return volume.at(x.low, j, k) * (1 - x.fraction) + volume.at(x.high, j, k) * x.fraction;
  };
  const auto plane = [&](int k) { return row(y.low, k) * (1 - y.fraction) + row(y.high, k) * y.fraction; };
  return plane(z.low) * (1 - z.fraction) + plane(z.high) * z.fraction;
}

std::uint8_t sampleNearest(const LabelMap& labels, Vec3 index, std::uint8_t outside) {
  if (!isFinite(index)) return outside;
  const double i = std::floor(index.x + 0.5), j = std::floor(index.y + 0.5), k = std::floor(index.z + 0.5);
  const auto& size = labels.geometry.size;
  if (i < 0 || j < 0 || k < 0 || i >= size[0] || j >= size[1] || k >= size[2]) return outside;
  return labels.at(static_cast<int>(i), static_cast<int>(j), static_cast<int>(k));
}

}  // namespace insonate
