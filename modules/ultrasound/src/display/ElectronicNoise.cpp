#include "ElectronicNoise.h"

#include <insonate/core/Hash.h>
#include <insonate/ultrasound/PointSpread.h>

#include <algorithm>
#include <cmath>
#include <mutex>

namespace insonate::display {
namespace {

/// Full width at half maximum of a cubic B-spline, in distances between its nodes.
constexpr double kSplineFwhm = 1.4448;
/// Places in the field at which the noise of a frame can begin.
constexpr int kRowShifts = 256, kColumnShifts = 64;

double cubicSpline(double x) {
  const double a = std::abs(x);
  if (a >= 2) return 0;
  return a < 1 ? 2.0 / 3 - a * a * (1 - a / 2) : std::pow(2 - a, 3) / 6;
}

/// Samples between the splines' nodes at a depth, as wide as the pulse, since the noise has passed the receive filter.
double nodeDistance(const Probe& probe, const ImagingSettings& settings, double range_mm) {
  const double step_mm = BeamGrid(probe, settings).step_mm();
  return std::max(axialFwhm_mm(probe, settings, range_mm) / (kSplineFwhm * step_mm), 1.0);
}

NoiseField::Shape shapeOf(const Probe& probe, const ImagingSettings& settings, const DisplayPlan& plan) {
  const double atFace = nodeDistance(probe, settings, 0), atBottom = nodeDistance(probe, settings, settings.depth_mm);
  return {plan.samples + kRowShifts, plan.scanlines + kColumnShifts, settings.looks, atFace,
          (atBottom - atFace) / plan.samples};
}

/// Complex noise of unit power by rows of samples: [real, imaginary][row].
Plane complexNoise(const NoiseField::Shape& shape) {
  const auto [rows, columns, looks, distance, growth] = shape;
  const int nodes = static_cast<int>(rows / distance) + 4;
  Plane white(2 * nodes, columns), noise(2 * rows, columns);
  for (int n = 0; n < nodes; ++n)
    whiteRow(
        {.seed = hashNode(n, 0, 0, 0), .columns = columns, .real = white.row(n), .imaginary = white.row(nodes + n)});
  double place = 0;
  for (int k = 0; k < rows; ++k, place += 1 / (distance + growth * std::max(k - kRowShifts / 2, 0))) {
    const int node = static_cast<int>(place);
    double weight[4], power = 0;
    for (int tap = 0; tap < 4; ++tap) {
      weight[tap] = cubicSpline(place - node + 1 - tap);
      power += weight[tap] * weight[tap];
    }
    for (int tap = 0; tap < 4; ++tap) {
      const auto scale = static_cast<float>(weight[tap] / std::sqrt(2 * power));
      for (const int plane : {0, 1}) {
        const float* const from = white.row(plane * nodes + node + tap);
        float* const to = noise.row(plane * rows + k);
        for (int i = 0; i < columns; ++i) to[i] += scale * from[i];
      }
    }
  }
  return noise;
}

/// Noise of the mean of this number of looks, each of unit power: [power, twice in phase][row].
Plane meanNoise(const NoiseField::Shape& shape) {
  const int rows = shape.rows, looks = shape.looks;
  const Plane noise = complexNoise(shape);
  const float share = 1 / static_cast<float>(looks);
  Plane field(2 * rows, shape.columns);
  for (int k = 0; k < rows; ++k) {
    float *const power = field.row(k), *const twiceInPhase = field.row(rows + k);
    const float *const real = noise.row(k), *const imaginary = noise.row(rows + k);
    for (int look = 0; look < looks; ++look)
      for (int i = 0; i < shape.columns; ++i) {
        // Each look has independent noise: other columns of the same field.
        const int from = (i + look * (shape.columns / looks)) % shape.columns;
        power[i] += share * std::sqrt(real[from] * real[from] + imaginary[from] * imaginary[from]);
        twiceInPhase[i] += 2 * share * real[from];
      }
    for (int i = 0; i < shape.columns; ++i) power[i] *= power[i];
  }
  return field;
}

/// The field of this shape. The last one is cached, since most settings do not change it.
std::shared_ptr<const NoiseField> fieldOf(const NoiseField::Shape& shape) {
  static std::mutex mutex;
  static std::shared_ptr<const NoiseField> last;
  const std::lock_guard lock(mutex);
  if (!last || last->shape != shape) last = std::make_shared<const NoiseField>(NoiseField{shape, meanNoise(shape)});
  return last;
}

}  // namespace

ElectronicNoise::ElectronicNoise(const Probe& probe, const ImagingSettings& settings, const DisplayPlan& plan)
    : time_(static_cast<std::uint32_t>(std::llround(settings.time_s * 1000))),
      amplitude_(
          static_cast<float>(std::pow(10, (settings.noise_dB - (settings.harmonic ? kHarmonicLevel_dB : 0)) / 20))),
      field_(fieldOf(shapeOf(probe, settings, plan))) {}

void ElectronicNoise::draw(std::uint32_t seed) {
  const std::uint32_t place = hash32(hash32(seed) + time_);
  firstRow_ = static_cast<int>(place % kRowShifts);
  firstColumn_ = static_cast<int>(place / kRowShifts % kColumnShifts);
}

NoiseRow ElectronicNoise::row(int sample) const {
  const int row = firstRow_ + sample;
  return {field_->values.row(row) + firstColumn_, field_->values.row(field_->shape.rows + row) + firstColumn_,
          amplitude_};
}

}  // namespace insonate::display
