#pragma once

#include "model/FramePlan.h"

#include <span>
#include <vector>

namespace insonate {

/// Behind gas nothing comes back but the tissue above, mirrored, and rings between the gas and the probe, each ring a
/// repeat of the surface's own echo. A mucosa is no mirror: rings come and go along it, each in its own way.
class Reverberation {
 public:
  static constexpr int kFirstGate = 2;  ///< behind the surface: the surface's own echo is not covered

  /// The echo of the gate this far above the surface repeats with this share, times the strength of its ring.
  struct Repeat {
    int gatesAbove;
    float share;
    int ring;  ///< 0 is the mirrored tissue
  };

  explicit Reverberation(const FramePlan& plan);

  /// Strength of each ring from a point of the surface, by ring: 1 on average.
  void strengthsAt(Vec3 surface_mm, std::span<float> strength) const;
  int rings() const { return rings_; }

  /// Repeats that arrive at a gate this far behind the surface.
  std::span<const Repeat> at(int gatesBehind) const {
    return {repeats_.data() + first_[gatesBehind], repeats_.data() + first_[gatesBehind + 1]};
  }

 private:
  std::vector<Repeat> repeats_;
  std::vector<int> first_;
  int rings_ = 1;
};

}  // namespace insonate
