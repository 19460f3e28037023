#include "FaceEchoes.h"

#include <insonate/core/Hash.h>
#include <insonate/ultrasound/PointSpread.h>

#include <algorithm>
#include <cmath>

namespace insonate::display {
namespace {

constexpr double kRinging_mm = 0.18;  ///< depth in which the ringing of the elements decreases to 1/e
constexpr double kLens_mm = 0.75;  ///< distance between echoes of the lens in the image, at the sound speed of tissue
constexpr double kSkinEcho = 0.16, kAirEcho = 0.2;  ///< amplitude of an echo of the lens relative to the one before
constexpr double kSpread = 0.35;     ///< increase of length from one echo to the next, in pulses, since the lens
                                     ///< absorbs
constexpr double kInaudible = 1e-3;  ///< amplitude at the face below which echoes are ignored
constexpr double kElements_dB = 2, kElements_mm = 0.9;  ///< range of the difference between elements, and its width
constexpr double kLifted_dB = -22;                      ///< loss, one way, through the last film of gel
constexpr double kWedge_mm = 9;                         ///< length over which that film opens into air
constexpr double kWedgeInside_mm = 3;  ///< part of it beyond the set strip, where the skin still nearly touches
constexpr double kBubbles = 1.4, kBubble_mm = 0.6;  ///< variation of contact in the wedge, and its length
constexpr double kNarrowest_elements = 4;           ///< smallest aperture

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

/// Value noise along the face, -1 to 1; the same for equal probes and settings.
double bubblesAt(double place_mm) {
  const double place = place_mm / kBubble_mm;
  const int node = static_cast<int>(place);
  const auto at = [](int n) { return 2 * unitInterval(hashNode(n, 1, 0, 0)) - 1; };
  return at(node) + (place - node) * (at(node + 1) - at(node));
}

/// Position of a place within the wedge of a strip at one end of the face; 0 without a strip.
double within(double strip_mm, double fromEnd_mm) {
  return strip_mm > 0 ? strip_mm + kWedgeInside_mm - fromEnd_mm : 0;
}

/// Running sums, for the mean over an aperture of either width. There are no elements beyond the ends.
class ShareOfAperture {
 public:
  explicit ShareOfAperture(const std::vector<double>& touching) : before_(1, 0.0) {
    for (const double amplitude : touching) before_.push_back(before_.back() + amplitude);
  }
  double at(int line, double lines) const {
    const double last = double(before_.size()) - 1;
    const double from = std::max(line + 0.5 - lines / 2, 0.0), to = std::min(line + 0.5 + lines / 2, last);
    return (sumTo(to) - sumTo(from)) / (to - from);
  }

 private:
  double sumTo(double place) const {
    const int n = std::min(static_cast<int>(place), static_cast<int>(before_.size()) - 2);
    return before_[n] + (place - n) * (before_[n + 1] - before_[n]);
  }

  std::vector<double> before_;
};

}  // namespace

FaceEchoes::FaceEchoes(const Probe& probe, const ImagingSettings& settings, const DisplayPlan& plan)
    : columns_(plan.scanlines), line_(1, columns_), lack_(1, columns_) {
  const BeamGrid grid(probe, settings);
  findContact(probe, settings, plan, grid);
  findRinging(probe, settings, grid);
}

void FaceEchoes::findContact(const Probe& probe, const ImagingSettings& settings, const DisplayPlan& plan,
                             const BeamGrid& grid) {
  // All scanlines of a phased array use the whole array.
  if (probe.shape == ProbeShape::Phased || (settings.poorContactLeft_mm <= 0 && settings.poorContactRight_mm <= 0))
    return;
  const double spacing_mm = grid.scanlineSpacing_mm(0);
  std::vector<double> touching(columns_);
  for (int l = 0; l < columns_; ++l) {
    const double left = within(settings.poorContactLeft_mm, l * spacing_mm);
    const double right = within(settings.poorContactRight_mm, (columns_ - 1 - l) * spacing_mm);
    const double t = std::clamp(std::max(left, right) / kWedge_mm, 0.0, 1.0), open = t * t * (3 - 2 * t);
    const double ragged = open * (1 + kBubbles * (1 - open) * bubblesAt(l * spacing_mm));
    const double lifted = std::clamp(ragged, 0.0, 1.0);
    lack_.row(0)[l] = static_cast<float>(lifted * lifted);
    touching[l] = std::pow(10, kLifted_dB * lifted / 20);
  }
  const ShareOfAperture share(touching);
  const double narrowest_mm = kNarrowest_elements * probe.pitch_mm;
  contact_.emplace(static_cast<int>(plan.blocks.size()), columns_);
  for (int b = 0; b < contact_->rows(); ++b) {
    const double depth_mm = grid.range_mm(plan.blocks[b].first + 0.5 * (plan.blocks[b].count - 1));
    // Only elements whose cone includes a point in front of the transmit focus reach the point.
    const double sending_mm = std::clamp(std::min(depth_mm, settings.focus_mm) / probe.transmitFNumber, narrowest_mm,
                                         std::max(probe.maxAperture_mm, narrowest_mm));
    const double receiving_mm =
        std::clamp(depth_mm / probe.receiveFNumber, narrowest_mm, std::max(probe.maxAperture_mm, narrowest_mm));
    for (int l = 0; l < columns_; ++l)
      contact_->row(b)[l] =
          static_cast<float>(share.at(l, sending_mm / spacing_mm) * share.at(l, receiving_mm / spacing_mm));
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
    // The setting is the level in the image.
    const double filtered_dB = settings.harmonic ? kHarmonicLevel_dB : 0;
    const double level_dB = settings.ringing_dB + filtered_dB - nearLevel_dB(probe, depth_mm);
    touching_.push_back(powerOf(ringing(depth_mm, pulse_mm, kSkinEcho), level_dB));
    lifted_.push_back(powerOf(ringing(depth_mm, pulse_mm, kAirEcho), level_dB));
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
