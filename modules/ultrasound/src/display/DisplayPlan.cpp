#include "DisplayPlan.h"

#include "Plane.h"

#include <insonate/ultrasound/Display.h>
#include <insonate/ultrasound/PointSpread.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace insonate::display {
namespace {

/// Weights of a Gaussian with unit sum, for taps at 0, +-spacing, +-2 spacing, ...
template <std::size_t N>
void gaussianTaps(double sd, double spacing, float (&weight)[N]) {
  double value[N], sum = 0;
  for (std::size_t t = 0; t < N; ++t) {
    value[t] = std::exp(-0.5 * std::pow(double(t) * spacing / sd, 2));
    sum += t == 0 ? value[t] : 2 * value[t];
  }
  for (std::size_t t = 0; t < N; ++t) weight[t] = static_cast<float>(value[t] / sum);
}

int strideFor(double length, double spacing, int most) {
  return static_cast<int>(std::clamp(std::round(length / spacing), 1.0, double(most)));
}

/// The 8 sliders are at the centers of 8 equal parts; between them the gain is smooth, without overshoot.
double slider_dB(const std::array<double, 8>& sliders_dB, double share) {
  const double place = std::clamp(share * 8 - 0.5, 0.0, 7.0);
  const int i = std::min(static_cast<int>(place), 6);
  const double mix = 0.5 - 0.5 * std::cos(std::numbers::pi * (place - i));
  return sliders_dB[i] + mix * (sliders_dB[i + 1] - sliders_dB[i]);
}

Block makeBlock(const Probe& probe, const ImagingSettings& settings, const BeamGrid& grid, int first, int count,
                double block_mm) {
  Block block;
  block.first = first, block.count = count;
  const double range_mm = grid.range_mm(first + 0.5 * (count - 1));
  const double spacing_mm = grid.scanlineSpacing_mm(range_mm);
  const double axial_mm = axialFwhm_mm(probe, settings), lateral_mm = lateralFwhm_mm(probe, settings, range_mm);

  block.edgeStride = strideFor(0.5 * lateral_mm, spacing_mm, 12);
  block.edgeLateral = static_cast<float>(lateral_mm / (2 * block.edgeStride * spacing_mm));
  block.edgeAxial = static_cast<float>(axial_mm / (2 * block_mm));
  block.plainStride = strideFor(kPlainLateralSd * lateral_mm, spacing_mm, 12);
  gaussianTaps(kPlainLateralSd * lateral_mm, block.plainStride * spacing_mm, block.plainWeight);
  block.alongStride = strideFor(kAlongSd * lateral_mm, spacing_mm, 10);
  gaussianTaps(kAlongSd * lateral_mm, block.alongStride * spacing_mm, block.alongWeight);
  block.rowsPerSlope = static_cast<float>(axial_mm / lateral_mm * block.alongStride * spacing_mm / grid.step_mm());
  const double variance_mm2 = kHazeSpread_mm * kHazeSpread_mm * block_mm / kHazeTail_mm;
  constexpr double kMostShare = 0.25;
  const double halfVariance = variance_mm2 / (2 * spacing_mm * spacing_mm);
  block.hazeStride = std::clamp(static_cast<int>(std::ceil(std::sqrt(halfVariance / kMostShare))), 1, Plane::kMargin);
  block.hazeSpread = static_cast<float>(std::min(halfVariance / (block.hazeStride * block.hazeStride), kMostShare));
  return block;
}

}  // namespace

double nearLevel_dB(const Probe& probe, double depth_mm) {
  if (probe.shape == ProbeShape::Phased) return 0;  // all elements, at every depth
  const double full_mm = std::min(kFullAperture_mm, probe.maxAperture_mm);
  const double aperture_mm = std::clamp(depth_mm / probe.receiveFNumber, kFewElements * probe.pitch_mm, full_mm);
  return kNearShare * 20 * std::log10(aperture_mm / full_mm);
}

DisplayPlan::DisplayPlan(const Probe& probe, const ImagingSettings& settings)
    : scanlines(settings.scanlines), samples(settings.samples) {
  const BeamGrid grid(probe, settings);
  const double axial_mm = axialFwhm_mm(probe, settings);
  blockRows = strideFor(0.9 * axial_mm, grid.step_mm(), 64);
  const double block_mm = blockRows * grid.step_mm();
  for (int first = 0; first < samples; first += blockRows)
    blocks.push_back(makeBlock(probe, settings, grid, first, std::min(blockRows, samples - first), block_mm));
  hazeDecay = static_cast<float>(std::exp(-block_mm / kHazeTail_mm));
  hazeGrainDecay = static_cast<float>(std::exp(-block_mm / kHazeGrain_mm));
  longHazeFrom = static_cast<int>(std::ceil(kHazeLongFrom_mm / block_mm));
  hazeLongDecay = static_cast<float>(std::exp(-block_mm / kHazeLongTail_mm));

  for (int k = 0; k < samples; ++k) {
    const double depth_cm = grid.range_mm(k) / 10;
    // Without attenuation there is no loss to compensate.
    const double builtIn_dB =
        settings.effects.attenuation ? std::min(kTgc_dBpcmMHz * settings.frequency_MHz * depth_cm, kMaxTgc_dB) : 0;
    rowGain.push_back(static_cast<float>(std::pow(10, builtIn_dB / 20)));
    const double near_dB = settings.effects.nearField ? nearLevel_dB(probe, grid.range_mm(k)) : 0;
    rowOffset_dB.push_back(static_cast<float>(settings.gain_dB + near_dB +
                                              slider_dB(settings.tgc_dB, grid.range_mm(k) / settings.depth_mm)));
  }
  axialStride = strideFor(kPlainAxialSd * axial_mm, grid.step_mm(), 64);
  gaussianTaps(kPlainAxialSd * axial_mm, axialStride * grid.step_mm(), axialWeight);

  edgeRows = strideFor(0.5 * axial_mm, grid.step_mm(), 64);
  if (settings.lateralGain_dB != std::array<double, 8>{}) {
    line_dB.assign(Plane::padded(scanlines), 0);
    for (int l = 0; l < scanlines; ++l)
      line_dB[l] = static_cast<float>(slider_dB(settings.lateralGain_dB, (l + 0.5) / scanlines));
  }

  planShade(probe, settings, grid);
  black_dB = static_cast<float>(kWhite_dB - settings.dynamicRange_dB);
  perLevel = static_cast<float>(1 / settings.dynamicRange_dB);
  low_dB = static_cast<float>(black_dB - kHeadroom_dB);
  high_dB = static_cast<float>(kWhite_dB + kHeadroom_dB);
}

void DisplayPlan::planShade(const Probe& probe, const ImagingSettings& settings, const BeamGrid& grid) {
  const double spacing_mm = grid.scanlineSpacing_mm(0.5 * (kShadeFrom_mm + kShadeTo_mm));
  const auto within = [&](double mm) { return std::clamp(static_cast<int>(mm / spacing_mm), 1, scanlines / 2); };
  streakNarrow = within(kStreakNarrow_mm), streakWide = within(kStreakWide_mm);
  const double block_mm = blockRows * grid.step_mm();
  const auto blockAt = [&](double mm) {
    return std::min(static_cast<int>(mm / block_mm), static_cast<int>(blocks.size()));
  };
  shadeFirst = blockAt(kShadeFrom_mm), shadeEnd = blockAt(kShadeTo_mm);
  edgeShade_dB.assign(Plane::padded(scanlines), 0);
  // All scanlines of a phased array use the whole array.
  if (probe.shape != ProbeShape::Phased)
    for (int l = 0; l < scanlines; ++l) {
      const double fromEnd_mm = std::min(l, scanlines - 1 - l) * spacing_mm;
      const double near = std::max(1 - fromEnd_mm / kEdgeWidth_mm, 0.0);
      edgeShade_dB[l] = static_cast<float>(-kEdgeLoss_dB * near * near);
    }
  for (int k = 0; k < samples; ++k) {
    const double t = std::clamp((grid.range_mm(k) - kShadeTo_mm) / (kShadeFull_mm - kShadeTo_mm), 0.0, 1.0);
    shadeShare.push_back(settings.effects.attenuation ? static_cast<float>(t * t * (3 - 2 * t)) : 0.0F);
  }
}

DisplayPlan::Between DisplayPlan::between(int row) const {
  const float place = (static_cast<float>(row) + 0.5F) / static_cast<float>(blockRows) - 0.5F;
  const int last = static_cast<int>(blocks.size()) - 1;
  const int before = std::min(static_cast<int>(std::max(place, 0.0F)), last);
  return {before, std::min(before + 1, last), std::clamp(place - static_cast<float>(before), 0.0F, 1.0F)};
}

}  // namespace insonate::display
