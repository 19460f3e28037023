#include "FaceEchoes.h"

#include <insonate/core/Hash.h>
#include <insonate/ultrasound/PointSpread.h>

#include <algorithm>
#include <cmath>

namespace insonate::display {
namespace {

constexpr double kRinging_mm = 0.18;  ///< in which the ringing of the elements falls to 1/e
constexpr double kLens_mm = 0.75;  ///< between echoes of the lens, as the image shows them at the sound speed of tissue
constexpr double kSkinEcho = 0.22, kAirEcho = 0.5;  ///< what each echo of the lens keeps of the one before
constexpr double kSpread = 0.35;     ///< by which each echo is longer than the one before, in pulses: the lens absorbs
constexpr double kInaudible = 1e-3;  ///< of an amplitude at the face
constexpr double kElements_dB = 2, kElements_mm = 0.9;  ///< range of the difference between elements, and its width
constexpr double kLifted_dB = -28, kTaper_mm = 3;       ///< what passes through air, and how contact returns

/// Amplitude at a depth, 1 at the face.
double ringing(double depth_mm, double pulse_mm, double lensEcho) {
  double sum = std::exp(-depth_mm / kRinging_mm), echo = 1;
  for (int n = 1; echo > kInaudible; ++n) {
    echo *= lensEcho;
    const double length_mm = pulse_mm * (1 + kSpread * n);
    sum += echo * std::exp(-4 * std::log(2.0) * std::pow((depth_mm - n * kLens_mm) / length_mm, 2));
  }
  return sum;
}

float powerOf(double amplitude, double level_dB) {
  return static_cast<float>(amplitude * amplitude * std::pow(10, level_dB / 10));
}

}  // namespace

FaceEchoes::FaceEchoes(const Probe& probe, const ImagingSettings& settings, const DisplayPlan& plan)
    : columns_(plan.scanlines), line_(1, columns_), lack_(1, columns_) {
  const BeamGrid grid(probe, settings);
  findContact(probe, settings, grid);
  findRinging(probe, settings, grid);
}

void FaceEchoes::findContact(const Probe& probe, const ImagingSettings& settings, const BeamGrid& grid) {
  const double spacing_mm = grid.scanlineSpacing_mm(0);
  contact_.assign(columns_, 1);
  // All scanlines of a phased array use all of it.
  if (probe.shape == ProbeShape::Phased) return;
  for (int l = 0; l < columns_; ++l) {
    const double left = settings.poorContactLeft_mm - l * spacing_mm;
    const double right = settings.poorContactRight_mm - (columns_ - 1 - l) * spacing_mm;
    const double t = std::clamp(std::max(left, right) / kTaper_mm, 0.0, 1.0), lifted = t * t * (3 - 2 * t);
    lack_.row(0)[l] = static_cast<float>(lifted);
    contact_[l] = static_cast<float>(std::pow(10, kLifted_dB * lifted / 20));
    lifts_ = lifts_ || lifted > 0;
  }
}

void FaceEchoes::findRinging(const Probe& probe, const ImagingSettings& settings, const BeamGrid& grid) {
  const double perNode = std::max(kElements_mm / grid.scanlineSpacing_mm(0), 1.0);
  for (int l = 0; l < columns_; ++l) {
    const double place = l / perNode;
    const int node = static_cast<int>(place);
    const double before = unitInterval(hashNode(node, 0, 0, 0)), after = unitInterval(hashNode(node + 1, 0, 0, 0));
    line_.row(0)[l] = powerOf(1, kElements_dB * (before + (place - node) * (after - before) - 0.5));
  }
  const double pulse_mm = axialFwhm_mm(probe, settings);
  const double end_mm = (std::log(kInaudible) / std::log(kAirEcho) + 3) * kLens_mm;
  for (int k = 0; k < grid.samples() && grid.range_mm(k) < end_mm; ++k) {
    const double depth_mm = grid.range_mm(k);
    touching_.push_back(powerOf(ringing(depth_mm, pulse_mm, kSkinEcho), settings.ringing_dB));
    lifted_.push_back(powerOf(ringing(depth_mm, pulse_mm, kAirEcho), settings.ringing_dB));
  }
}

void FaceEchoes::addTo(float* power, int row, float rowGain) const {
  if (row >= static_cast<int>(touching_.size())) return;
  const float gain = rowGain * rowGain;
  ringingRow({.line = line_.row(0),
              .lack = lack_.row(0),
              .touching = touching_[row] * gain,
              .lifted = lifted_[row] * gain,
              .columns = columns_,
              .power = power});
}

}  // namespace insonate::display
