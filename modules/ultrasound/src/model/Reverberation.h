#pragma once

#include "model/FramePlan.h"

#include <span>
#include <vector>

namespace insonate {

/// Echoes behind gas. Only two kinds of echoes arrive from there: the tissue above, mirrored, and rings between the gas
/// and the probe, each of which repeats the surface's own echo. A mucosa is not smooth: the strength of each ring
/// varies along it independently.
class Reverberation {
 public:
  static constexpr int kFirstGate = 2;  ///< gates behind the surface; the surface's own echo is not replaced

  /// The echo of a gate at this distance above the surface is repeated with this share, multiplied by the strength of
  /// its ring.
  struct Repeat {
    int gatesAbove;
    float share;
    int ring;  ///< 0: the mirrored tissue
  };

  explicit Reverberation(const FramePlan& plan);

  /// Strength of each ring at a point of the surface; 1 on average.
  void strengthsAt(Vec3 surface_mm, std::span<float> strength) const;
  int rings() const { return rings_; }

  /// Repeats that arrive at a gate at this distance behind the surface.
  std::span<const Repeat> at(int gatesBehind) const {
    return {repeats_.data() + first_[gatesBehind], repeats_.data() + first_[gatesBehind + 1]};
  }

 private:
  std::vector<Repeat> repeats_;
  std::vector<int> first_;
  int rings_ = 1;
};

}  // namespace insonate
