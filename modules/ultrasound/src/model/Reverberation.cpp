#include "model/Reverberation.h"

#include "scene/TextureTiles.h"

#include <algorithm>
#include <cmath>

namespace insonate {

Reverberation::Reverberation(const FramePlan& plan) {
  using namespace acoustics;
  constexpr int kRingHalfWidth_gates = 1;
  const double ring_gates = kRingPeriod_mm / plan.gate_mm;
  for (int behind = 0; behind < plan.gates; ++behind) {
    first_.push_back(static_cast<int>(repeats_.size()));
    const double depth_mm = behind * plan.gate_mm;
    repeats_.push_back({behind, static_cast<float>(kMirrorShare * std::exp(-depth_mm / kMirrorDecay_mm)), 0});
    const int ring = static_cast<int>(std::lround(behind / ring_gates));
    const int off = static_cast<int>(std::lround(ring * ring_gates)) - behind;
    if (ring > 0 && std::abs(off) <= kRingHalfWidth_gates)
      repeats_.push_back(
          {off + kRingHalfWidth_gates, static_cast<float>(kRingShare * std::exp(-depth_mm / kRingDecay_mm)), ring});
    rings_ = std::max(rings_, ring + 1);
  }
  first_.push_back(static_cast<int>(repeats_.size()));
}

void Reverberation::strengthsAt(Vec3 surface_mm, std::span<float> strength) const {
  const TextureTile& patches = patchTile();
  const Vec3 voxel = surface_mm / patches.voxel_mm.x;
  for (int ring = 0; ring < rings_; ++ring) {
    // Another part of the field for every repetition.
    const double patch = patches.at(voxel + double(ring) * Vec3{17, 29, 41}) / 32.0;
    strength[ring] = static_cast<float>(std::clamp(1 + 1.2 * patch, 0.0, 2.5));
  }
}

}  // namespace insonate
