#include "Haze.h"

#include "ReceiveKernels.h"

#include <insonate/core/Hash.h>

#include <cmath>
#include <numbers>

namespace insonate::display {
namespace {

constexpr double kRipples = 1000;  ///< far from where the drift is read

float powerOf(double level_dB) {
  return static_cast<float>(std::pow(10, level_dB / 10));
}

/// Smooth interpolation between hashes of whole numbers, -1 to 1.
double valueNoise(double x, double y) {
  const double i = std::floor(x), j = std::floor(y);
  const auto at = [&](int right, int down) {
    return 2 * unitInterval(hashNode(static_cast<int>(i) + right, static_cast<int>(j) + down, 2, 0)) - 1;
  };
  const auto eased = [](double t) { return 0.5 - 0.5 * std::cos(std::numbers::pi * t); };
  const double across = eased(x - i), down = eased(y - j);
  return std::lerp(std::lerp(at(0, 0), at(1, 0), across), std::lerp(at(0, 1), at(1, 1), across), down);
}

}  // namespace

Haze::Haze(const Probe& probe, const ImagingSettings& settings, const DisplayPlan& plan)
    : plan_(&plan),
      tail_(static_cast<int>(plan.blocks.size()), plan.scanlines),
      grain_(tail_.rows(), plan.scanlines),
      longTail_(tail_.rows(), plan.scanlines),
      haze_(tail_.rows(), plan.scanlines),
      drift_(tail_.rows(), plan.scanlines),
      smeared_(1, plan.scanlines) {
  const BeamGrid grid(probe, settings);
  for (int b = 0; b < drift_.rows(); ++b) {
    const double range_mm = grid.range_mm(plan.blocks[b].first + 0.5 * (plan.blocks[b].count - 1));
    const double spacing_mm = grid.scanlineSpacing_mm(range_mm);
    smearing_.push_back(static_cast<float>(std::exp(-spacing_mm / kSmear_mm)));
    for (int l = 0; l < plan.scanlines; ++l)
      drift_.row(b)[l] = powerOf(
          (settings.harmonic ? kHarmonicHaze_dB : 0) +
          kDriftReach_dB * valueNoise(l * spacing_mm / kDriftLateral_mm, range_mm / kDriftAxial_mm) +
          kRippleReach_dB * valueNoise(kRipples + l * spacing_mm / kRippleLateral_mm, range_mm / kRippleAxial_mm));
  }
}

void Haze::follow(Plane& blockPower, Plane& strongPower, const FaceEchoes* face) {
  blockPower.extendRow(0);
  strongPower.extendRow(0);
  for (int b = 0; b < haze_.rows(); ++b) {
    smear(blockPower, face ? face->contact(b) : nullptr, b);
    hazeRow({.power = blockPower.row(b),
             .strong = strongPower.row(b),
             .tailAbove = b == 0 ? blockPower.row(0) : tail_.row(b - 1),
             .grainAbove = b == 0 ? blockPower.row(0) : grain_.row(b - 1),
             .longAbove = b == 0 ? strongPower.row(0) : longTail_.row(b - 1),
             .stride = plan_->blocks[b].hazeStride,
             .spread = plan_->blocks[b].hazeSpread,
             .tailDecay = plan_->hazeDecay,
             .grainDecay = plan_->hazeGrainDecay,
             .longDecay = plan_->hazeLongDecay,
             .share = powerOf(kHazeShare_dB),
             .longShare = powerOf(kHazeLongShare_dB),
             .smoothShare = static_cast<float>(kHazeSmoothShare),
             .smeared = smeared_.row(0),
             .drift = drift_.row(b),
             .columns = plan_->scanlines,
             .tail = tail_.row(b),
             .grain = grain_.row(b),
             .longTail = longTail_.row(b),
             .haze = haze_.row(b)});
    tail_.extendRow(b);
    grain_.extendRow(b);
    longTail_.extendRow(b);
  }
}

/// An exponential to either side, of the echoes from beside and from half the depth.
void Haze::smear(const Plane& blockPower, const float* contact, int b) {
  const float lobes = powerOf(kSideLobes_dB), twice = powerOf(kTwice_dB), on = smearing_[b];
  const float *here = blockPower.row(b), *half = blockPower.row(b / 2);
  float* const out = smeared_.row(0);
  const auto source = [&](int l) { return (1 - on) * (lobes * here[l] + twice * half[l]); };
  const int lines = plan_->scanlines;
  float sum = source(0) / (1 - on);
  for (int l = 0; l < lines; ++l) out[l] = sum = on * sum + source(l);
  sum = source(lines - 1) / (1 - on);
  for (int l = lines - 1; l >= 0; --l) {
    sum = on * sum + source(l);
    const float heard = contact ? contact[l] * contact[l] : 1;
    out[l] = 0.5F * heard * (out[l] + sum);
  }
}

}  // namespace insonate::display
