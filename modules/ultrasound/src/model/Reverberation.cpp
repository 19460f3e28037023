#include "model/Reverberation.h"

#include <cmath>

namespace insonate {

Reverberation::Reverberation(const FramePlan& plan) {
  using namespace acoustics;
  constexpr int kRingHalfWidth_gates = 1;
  const double ring_gates = kRingPeriod_mm / plan.gate_mm;
  for (int behind = 0; behind < plan.gates; ++behind) {
    first_.push_back(static_cast<int>(repeats_.size()));
    const double depth_mm = behind * plan.gate_mm;
    repeats_.push_back({behind, static_cast<float>(kMirrorShare * std::exp(-depth_mm / kMirrorDecay_mm))});
    const double ring = std::round(behind / ring_gates);
    const int off = static_cast<int>(std::lround(ring * ring_gates)) - behind;
    if (ring > 0 && std::abs(off) <= kRingHalfWidth_gates)
      repeats_.push_back(
          {off + kRingHalfWidth_gates, static_cast<float>(kRingShare * std::exp(-depth_mm / kRingDecay_mm))});
  }
  first_.push_back(static_cast<int>(repeats_.size()));
}

}  // namespace insonate
