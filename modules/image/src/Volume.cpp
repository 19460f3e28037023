#include <insonate/image/Volume.h>

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

struct Cell {
  int low, high;
  double fraction;
};

Cell cellOf(double index, int size) {
  const double clamped = std::clamp(index, 0.0, size - 1.0);
  const int low = std::min(static_cast<int>(clamped), std::max(size - 2, 0));
  return {low, std::min(low + 1, size - 1), clamped - low};
}

}  // namespace

double sampleLinear(const CtVolume& volume, Vec3 index) {
  const auto& size = volume.geometry.size;
  const Cell x = cellOf(index.x, size[0]), y = cellOf(index.y, size[1]), z = cellOf(index.z, size[2]);
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
