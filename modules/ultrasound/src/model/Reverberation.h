#pragma once

#include "model/FramePlan.h"

#include <span>
#include <vector>

namespace insonate {

/// Behind gas nothing comes back but the tissue above, mirrored, and rings between the gas and the probe, each ring a
/// repeat of the surface's own echo.
class Reverberation {
 public:
  static constexpr int kFirstGate = 2;  ///< behind the surface: the surface's own echo is not covered

  /// The echo of the gate so many above the surface comes again with this share.
  struct Repeat {
    int gatesAbove;
    float share;
  };

  explicit Reverberation(const FramePlan& plan);

  /// What is heard at a gate so many behind the surface.
  std::span<const Repeat> at(int gatesBehind) const {
    return {repeats_.data() + first_[gatesBehind], repeats_.data() + first_[gatesBehind + 1]};
  }

 private:
  std::vector<Repeat> repeats_;
  std::vector<int> first_;
};

}  // namespace insonate
