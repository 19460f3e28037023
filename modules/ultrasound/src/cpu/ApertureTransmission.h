#pragma once

#include "cpu/TraceInput.h"
#include "model/ApertureRays.h"

namespace insonate::cpu {

/// Two-way amplitude that remains of the beam at each gate, averaged over the rays of the aperture.
class ApertureTransmission {
 public:
  ApertureTransmission() = default;
  explicit ApertureTransmission(const FramePlan& plan);

  /// Amplitude at the face, for the scanlines from `line` on.
  float* contact(int line) { return contact_.get() + kMargin + line; }
  /// Share of the amplitude that a gate passes, for the scanlines from `line` on.
  float* passed(int gate, int line) { return passed_.get() + at(gate) + line; }

  /// Follows the rays. All members above must have been filled.
  void followRays();
  /// Scales a block's scattering by the amplitude that reaches it through the aperture, to zero if none does, and adds
  /// the boundaries.
  void light(int firstLine, BlockEchoes& echoes) const;

 private:
  static constexpr int kMargin = 16;
  std::size_t at(int gate) const { return std::size_t(gate) * width_ + kMargin; }
  void followRay(int ray);

  const FramePlan* plan_ = nullptr;
  int width_ = 0, lines_ = 0;
  AlignedArray<float> contact_, passed_;                       ///< [width], [gate][width]
  std::array<AlignedArray<float>, ApertureRays::kCount> ray_;  ///< [gate][width], before the loss in the gate itself
};

}  // namespace insonate::cpu
