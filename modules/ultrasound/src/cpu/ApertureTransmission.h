#pragma once

#include "cpu/TraceInput.h"
#include "model/ApertureRays.h"

namespace insonate::cpu {

/// Amplitude that is left of the beam at each gate, there and back, as the aperture sees it: the mean over its rays.
class ApertureTransmission {
 public:
  ApertureTransmission() = default;
  explicit ApertureTransmission(const FramePlan& plan);

  /// Amplitude at the face, for the scanlines from this one on.
  float* contact(int line) { return contact_.get() + kMargin + line; }
  /// Share that a gate lets pass, for the scanlines from this one on.
  float* passed(int gate, int line) { return passed_.get() + at(gate) + line; }

  /// Follows the rays; everything above must be known.
  void followRays();
  /// Makes a block's scattering as strong as what reaches it through the aperture, nothing where the aperture sees
  /// nothing, and adds the boundaries.
  void light(int firstLine, BlockEchoes& echoes) const;

 private:
  static constexpr int kMargin = 16;
  std::size_t at(int gate) const { return std::size_t(gate) * width_ + kMargin; }
  void followRay(int ray);

  const FramePlan* plan_ = nullptr;
  int width_ = 0, lines_ = 0;
  AlignedArray<float> contact_, passed_;                       ///< [width], [gate][width]
  std::array<AlignedArray<float>, ApertureRays::kCount> ray_;  ///< [gate][width], before the gate's own loss
};

}  // namespace insonate::cpu
