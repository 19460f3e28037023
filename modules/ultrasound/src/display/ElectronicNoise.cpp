#include "ElectronicNoise.h"

#include <insonate/core/Hash.h>
#include <insonate/ultrasound/PointSpread.h>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace insonate::display {
namespace {

/// Full width at half maximum of a cubic B-spline, in distances between its nodes.
constexpr double kSplineFwhm = 1.4448;
constexpr int kNodesPerTask = 32;

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
      nodes_(static_cast<int>(plan.samples / nodeDistance(probe, settings)) + 4),
      columns_(plan.scanlines),
      white_(2 * settings.looks * nodes_, plan.scanlines) {
  const double part = std::pow(10, settings.noise_dB / 20) / std::sqrt(2.0), distance = nodeDistance(probe, settings);
  for (int k = 0; k < plan.samples; ++k) {
    const double place = k / distance;
    Taps taps{static_cast<int>(place), {}};
    double weight[4], power = 0;
    for (int tap = 0; tap < 4; ++tap) {
      weight[tap] = cubicSpline(place - taps.node + 1 - tap);
      power += weight[tap] * weight[tap];
    }
    for (int tap = 0; tap < 4; ++tap) taps.weight[tap] = static_cast<float>(weight[tap] * part / std::sqrt(power));
    rows_.push_back(taps);
  }
}

void ElectronicNoise::draw(std::uint32_t seed, int looks) {
  const std::uint32_t frame = hash32(hash32(seed) + time_);
  tbb::parallel_for(tbb::blocked_range<int>(0, looks * nodes_, kNodesPerTask), [&](const auto& range) {
    for (int n = range.begin(); n < range.end(); ++n) {
      const int look = n / nodes_, node = n % nodes_;
      whiteRow({.seed = hashNode(node, look, 0, frame),
                .columns = columns_,
                .real = white_.row(2 * look * nodes_ + node),
                .imaginary = white_.row((2 * look + 1) * nodes_ + node)});
    }
  });
}

void ElectronicNoise::addTo(CompoundRow& task, int row) const {
  const Taps& taps = rows_[row];
  for (int look = 0; look < task.looks; ++look) {
    NoiseTaps& noise = task.noise[look];
    noise.real = white_.row(2 * look * nodes_ + taps.node);
    noise.imaginary = white_.row((2 * look + 1) * nodes_ + taps.node);
    noise.stride = white_.stride();
    std::copy_n(taps.weight, 4, noise.weight);
  }
}

}  // namespace insonate::display
