#include "ElectronicNoise.h"

#include <insonate/core/Hash.h>
#include <insonate/ultrasound/PointSpread.h>

#include <algorithm>
#include <cmath>

namespace insonate::display {
namespace {

/// Full width at half maximum of a cubic B-spline, in distances between its nodes.
constexpr double kSplineFwhm = 1.4448;
/// Places where a frame's noise may begin in the field.
constexpr int kRowShifts = 256, kColumnShifts = 64;

double cubicSpline(double x) {
  const double a = std::abs(x);
  if (a >= 2) return 0;
  return a < 1 ? 2.0 / 3 - a * a * (1 - a / 2) : std::pow(2 - a, 3) / 6;
}

/// Between nodes, in samples.
double nodeDistance(const Probe& probe, const ImagingSettings& settings) {
  const double step_mm = BeamGrid(probe, settings).step_mm();
  return std::max(axialFwhm_mm(probe, settings) / (kSplineFwhm * step_mm), 1.0);
}

}  // namespace

ElectronicNoise::ElectronicNoise(const Probe& probe, const ImagingSettings& settings, const DisplayPlan& plan)
    : time_(static_cast<std::uint32_t>(std::llround(settings.time_s * 1000))),
      rows_(plan.samples + kRowShifts),
      field_(2 * rows_, plan.scanlines + kColumnShifts) {
  const double part = std::pow(10, settings.noise_dB / 20) / std::sqrt(2.0), distance = nodeDistance(probe, settings);
  const int nodes = static_cast<int>(rows_ / distance) + 4, columns = plan.scanlines + kColumnShifts;
  Plane white(2 * nodes, columns);
  for (int n = 0; n < nodes; ++n)
    whiteRow(
        {.seed = hashNode(n, 0, 0, 0), .columns = columns, .real = white.row(n), .imaginary = white.row(nodes + n)});
  for (int k = 0; k < rows_; ++k) {
    const double place = k / distance;
    const int node = static_cast<int>(place);
    double weight[4], power = 0;
    for (int tap = 0; tap < 4; ++tap) {
      weight[tap] = cubicSpline(place - node + 1 - tap);
      power += weight[tap] * weight[tap];
    }
    for (int tap = 0; tap < 4; ++tap) {
      const auto scale = static_cast<float>(weight[tap] * part / std::sqrt(power));
      for (const int plane : {0, 1}) {
        const float* const from = white.row(plane * nodes + node + tap);
        float* const to = field_.row(plane * rows_ + k);
        for (int i = 0; i < columns; ++i) to[i] += scale * from[i];
      }
    }
  }
}

void ElectronicNoise::draw(std::uint32_t seed, int looks) {
  const std::uint32_t frame = hash32(hash32(seed) + time_);
  for (int look = 0; look < looks; ++look) {
    const std::uint32_t place = hashNode(look, 0, 0, frame);
    from_[look] = {static_cast<int>(place % kRowShifts), static_cast<int>(place / kRowShifts % kColumnShifts)};
  }
}

void ElectronicNoise::addTo(CompoundRow& task, int row) const {
  for (int look = 0; look < task.looks; ++look) {
    const auto [firstRow, firstColumn] = from_[look];
    task.noise[look] = {field_.row(firstRow + row) + firstColumn, field_.row(rows_ + firstRow + row) + firstColumn};
  }
}

}  // namespace insonate::display
