#pragma once

#include <insonate/core/Hash.h>
#include <insonate/core/Transform.h>

#include <cmath>
#include <cstdint>

/// Speckle of the thesis (equation 9): usnoise2d(x, y, p, r, t), Perlin's gradient noise over the texture coordinates
/// of the image, seeded by position and orientation of the probe and by the time. The lattice consists of integer
/// hashes, so that every engine, and a shader, uses the same lattice.
namespace insonate::thesis {

/// Number of octaves of the noise; each is twice as fine and half as strong as the one before.
inline constexpr int kNoiseOctaves = 2;
inline constexpr double kSeedPosition_mm = 0.1;  ///< smaller changes of the probe's position do not change the seed
/// Smaller changes of a component of the probe's axes do not change the seed.
inline constexpr double kSeedDirection = 0.01;
inline constexpr double kSeedTime_s = 0.001;

/// fade() is Perlin's quintic step from 0 to 1 ("Improving noise", 2002), fadeSlope() its slope.
constexpr double fade(double t) {
  return t * t * t * (10 + t * (-15 + 6 * t));
}
constexpr double fadeSlope(double t) {
  return 30 * t * t * (1 - t) * (1 - t);
}

struct NoiseGradient {
  double x, y;  ///< components of the gradient, each uniform in -1 to 1
};

constexpr NoiseGradient gradientAt(std::int32_t column, std::int32_t row, std::uint32_t seed) {
  const std::uint32_t h = hashNode(column, row, 0, seed);
  return {(h & 0xffffU) / 32767.5 - 1, (h >> 16) / 32767.5 - 1};
}

constexpr std::uint32_t octaveSeed(std::uint32_t seed, int octave) {
  return hash32(seed + 0x9e3779b9U * static_cast<std::uint32_t>(octave + 1));
}

/// Number of lattice cells of the noise's first octave along the width and the depth of the image.
struct NoiseCells {
  double across = 1, down = 1;
};

/// Returns the variance of one octave of the noise, over all gradients and positions in a cell: 8/3 times the integral
/// of w^2 times the integral of w^2 x^2 over a cell, with w = 1 - fade(x).
constexpr double octaveVariance() {
  constexpr int kSteps = 1000;
  double even = 0, arm = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double x = (i + 0.5) / kSteps, w = 1 - fade(x);
    even += w * w / kSteps;
    arm += w * w * x * x / kSteps;
  }
  return 8.0 / 3 * even * arm;
}

/// Returns the variance of the sum of all octaves of the noise, with squared amplitudes 1, 1/4, ...
constexpr double noiseVariance() {
  double sum = 0, power = octaveVariance();
  for (int o = 0; o < kNoiseOctaves; ++o, power /= 4) sum += power;
  return sum;
}

/// Returns one octave of gradient noise at a point: the contributions of the gradients at the four corners of the
/// lattice cell, interpolated along x and then along y.
inline double perlin(double x, double y, std::uint32_t seed) {
  const double i = std::floor(x), j = std::floor(y), dx = x - i, dy = y - j;
  const auto column = static_cast<std::int32_t>(i), row = static_cast<std::int32_t>(j);
  const auto vertex = [&](int c, int r) {
    const NoiseGradient g = gradientAt(column + c, row + r, seed);
    return g.x * (dx - c) + g.y * (dy - r);
  };
  const double above = vertex(0, 0) + fade(dx) * (vertex(1, 0) - vertex(0, 0));
  const double below = vertex(0, 1) + fade(dx) * (vertex(1, 1) - vertex(0, 1));
  return above + fade(dy) * (below - above);
}

/// Returns the thesis's noise at the texture coordinates x, y from 0 to 1, with zero mean and unit variance.
inline double usnoise2d(double x, double y, const NoiseCells& cells, std::uint32_t seed) {
  double sum = 0, scale = 1;
  for (int o = 0; o < kNoiseOctaves; ++o, scale *= 2)
    sum += perlin(x * cells.across * scale, y * cells.down * scale, octaveSeed(seed, o)) / scale;
  return sum / std::sqrt(noiseVariance());
}

/// Returns the seed of the noise from the probe's position p and orientation r and the time t of equation 9 of the
/// thesis.
inline std::uint32_t noiseSeed(const Transform& patientFromProbe, double time_s) {
  std::uint32_t seed = 0x75736e32U;
  const auto mixIn = [&seed](double value, double step) {
    seed = hash32(seed * 0x9e3779b1U + static_cast<std::uint32_t>(std::llround(value / step)));
  };
  for (int a = 0; a < 3; ++a) {
    mixIn(patientFromProbe.offset[a], kSeedPosition_mm);
    mixIn(patientFromProbe.linear.column[0][a], kSeedDirection);
    mixIn(patientFromProbe.linear.column[2][a], kSeedDirection);
  }
  mixIn(time_s, kSeedTime_s);
  return seed;
}

}  // namespace insonate::thesis
