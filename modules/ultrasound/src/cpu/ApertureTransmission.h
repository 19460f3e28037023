#pragma once

#include "cpu/TraceInput.h"
#include "model/ApertureRays.h"

namespace insonate::cpu {

/// Two-way amplitude that remains of the beam at each gate (point of a scanline at which echoes are computed), averaged
/// over rays from all parts of the aperture.
class ApertureTransmission {
 public:
  ApertureTransmission() = default;
  explicit ApertureTransmission(const FramePlan& plan);

  /// Returns the array of amplitudes at the face, for the scanlines from `line` on.
  float* contact(int line) { return contact_.get() + kMargin + line; }
  /// Returns the array of the shares of the amplitude that a gate passes, for the scanlines from `line` on.
  float* passed(int gate, int line) { return passed_.get() + at(gate) + line; }

  /// Multiplies the shares that gates pass, along each ray, from the face down. The arrays contact() and passed() must
  /// have been filled before.
  void followRays();
  /// Scales the scattering of a block of scanlines by the amplitude that reaches the scattering through the aperture
  /// (zero if none does), and then adds the block's boundary echoes.
  void light(int firstLine, BlockEchoes& echoes) const;

 private:
  static constexpr int kMargin = 16;
  std::size_t at(int gate) const { return std::size_t(gate) * width_ + kMargin; }
  void followRay(int ray);

  const FramePlan* plan_ = nullptr;
  int width_ = 0, lines_ = 0;
  AlignedArray<float> contact_, passed_;  ///< arrays of contact() and passed(): [width] and [gate][width]
  /// Amplitude along each ray, [gate][width], before the loss in the gate itself.
  std::array<AlignedArray<float>, ApertureRays::kCount> ray_;
};

}  // namespace insonate::cpu
