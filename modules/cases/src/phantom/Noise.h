#pragma once

#include <insonate/core/Hash.h>
#include <insonate/core/Vec3.h>

#include <cmath>

namespace insonate::phantom {

/// Smooth value noise in [-1, 1]: hashed lattice values with quintic interpolation (K. Perlin, "Improving noise",
/// 2002), which has continuous second derivatives. The lattice constant is one unit of p.
inline double smoothNoise(Vec3 p, std::uint32_t seed) {
  const double fx = std::floor(p.x), fy = std::floor(p.y), fz = std::floor(p.z);
  const auto i = static_cast<std::int32_t>(fx), j = static_cast<std::int32_t>(fy), k = static_cast<std::int32_t>(fz);
  const auto fade = [](double t) { return t * t * t * (t * (t * 6 - 15) + 10); };
  const double u = fade(p.x - fx), v = fade(p.y - fy), w = fade(p.z - fz);
  const auto row = [&](int dj, int dk) {
    const double a = unitInterval(hashNode(i, j + dj, k + dk, seed));
    const double b = unitInterval(hashNode(i + 1, j + dj, k + dk, seed));
    return a + (b - a) * u;
  };
  const auto plane = [&](int dk) {
    const double a = row(0, dk), b = row(1, dk);
    return a + (b - a) * v;
  };
  const double a = plane(0), b = plane(1);
  return 2 * (a + (b - a) * w) - 1;
}

/// Standard deviation of smoothNoise over space: sqrt((181/231)^3 / 3), where 1/3 is the variance of the lattice values
/// and 181/231 the mean squared weight of quintic interpolation in one axis.
inline constexpr double kSmoothNoiseSd = 0.4004;

}  // namespace insonate::phantom
