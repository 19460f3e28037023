#pragma once

#include <insonate/procedure/AttemptSample.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace insonate::test {

/// Two hands at work, a sample a millisecond: slow ways of centimeters, tremor of 9 and 11 Hz with 0.08 mm and 0.003
/// rad, and white noise of a tracker, 0.02 mm and 0.0002 rad (a device with steps of 0.05 mm has 0.016 mm).
inline std::vector<AttemptSample> handMotion(int count, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise;
  const auto tool = [&](double t, double phase) {
    const auto wave = [&](double hz, double more) { return std::sin(2 * std::numbers::pi * hz * t + phase + more); };
    Vec3 at_mm, turn;
    for (int axis = 0; axis < 3; ++axis) {
      at_mm[axis] = 20 * wave(0.1, axis) + 3 * wave(0.7, 2 * axis) + 0.08 * wave(9, axis) + 0.05 * wave(11.3, axis) +
                    0.02 * noise(random);
      turn[axis] = 0.4 * wave(0.07, axis) + 0.003 * wave(9, axis) + 0.0002 * noise(random);
    }
    const double angle = norm(turn);
    const Vec3 u = turn / angle;
    Transform pose;
    for (int c = 0; c < 3; ++c) {  // Rodrigues
      const Vec3 e{c == 0 ? 1.0 : 0.0, c == 1 ? 1.0 : 0.0, c == 2 ? 1.0 : 0.0};
      pose.linear.column[c] =
          e * std::cos(angle) + cross(u, e) * std::sin(angle) + u * (dot(u, e) * (1 - std::cos(angle)));
    }
    pose.offset = at_mm + Vec3{-40, -60, -250};
    return pose;
  };
  std::vector<AttemptSample> samples;
  for (int i = 0; i < count; ++i) {
    const double t = i * 1e-3;
    AttemptSample sample;
    sample.time_us = i * 1000LL + static_cast<std::int64_t>(20 * noise(random) + 100);
    sample.patientFromProbe = tool(t, 0), sample.patientFromNeedle = tool(t, 1.3);
    sample.probeForce_N = 2 + 0.5 * std::sin(t) + 0.01 * noise(random);
    sample.imageDepth_mm = 40;
    sample.aspirating = i / 3000 % 2 == 1;
    if (i / 10'000 % 2 == 1) {  // half of the time under the skin
      sample.needleDepth_mm = 15 + 10 * std::sin(0.6 * t) + 0.02 * noise(random);
      sample.toArtery_mm = 8 + 3 * std::sin(0.5 * t) + 0.02 * noise(random);
      sample.toVeinCenter_mm = 6 + 4 * std::sin(0.6 * t) + 0.02 * noise(random);
    }
    samples.push_back(sample);
  }
  return samples;
}

}  // namespace insonate::test
