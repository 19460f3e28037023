#include "model/Reverberation.h"

#include "scene/TextureTiles.h"

#include <algorithm>
#include <cmath>

namespace insonate {

Reverberation::Reverberation(const FramePlan& plan) {
  using namespace acoustics;
  constexpr int kRingHalfWidth_gates = 1;
  const double ring_gates = kRingPeriod_mm / plan.gate_mm;
  rings_ = static_cast<int>(std::lround((plan.gates - 1) / ring_gates)) + 1;
  gatesPerLayer_ = std::max(1, static_cast<int>(std::lround(patchTile().voxel_mm.x / plan.gate_mm)));
  layer_mm_ = gatesPerLayer_ * plan.gate_mm;
  layers_ = (plan.gates - 1) / gatesPerLayer_ + 1;
  for (int behind = 0; behind < plan.gates; ++behind) {
    first_.push_back(static_cast<int>(repeats_.size()));
    const double depth_mm = behind * plan.gate_mm;
    repeats_.push_back({behind, static_cast<float>(kMirrorShare * std::exp(-depth_mm / kMirrorDecay_mm)),
                        rings_ + behind / gatesPerLayer_});
    const int ring = static_cast<int>(std::lround(behind / ring_gates));
    const int off = static_cast<int>(std::lround(ring * ring_gates)) - behind;
    if (ring > 0 && std::abs(off) <= kRingHalfWidth_gates)
      repeats_.push_back(
          {off + kRingHalfWidth_gates, static_cast<float>(kRingShare * std::exp(-depth_mm / kRingDecay_mm)), ring});
  }
  first_.push_back(static_cast<int>(repeats_.size()));
}

void Reverberation::strengthsAt(Vec3 surface_mm, const AcousticScene::Impl& scene, const LungMotion& motion,
                                std::span<float> strength) const {
  const TextureTile& patches = patchTile();
  const double beside_mm = surface_mm.x - scene.trachea_mm;
  const bool isLung = std::abs(beside_mm) > AcousticScene::kLungFromTrachea_mm;
  const bool isSliding = isLung && std::abs(beside_mm) >= motion.detached_mm[beside_mm > 0 ? 1 : 0];
  const Vec3 slid = surface_mm - Vec3{0, 0, isSliding ? motion.slide_mm : 0};
  const Vec3 voxel = (slid - scene.textureOrigin_mm) / patches.voxel_mm.x;
  // Rounding as in the shader.
  const Vec3 rounding = Vec3{1, 1, 1} * TextureTile::kRounding_voxels;
  const auto at = [&](Vec3 offset, int finer = 1) {
    const double patch = patches.at((voxel + rounding) * finer + offset - rounding) / 32.0;
    return static_cast<float>(std::clamp(1 + 1.2 * patch, 0.0, 2.5));
  };
  // Another part of the field for every repetition.
  for (int ring = 0; ring < rings_; ++ring) strength[ring] = at(double(ring) * Vec3{17, 29, 41});
  for (int layer = 0; layer < layers_; ++layer)
    strength[rings_ + layer] = isLung
                                   ? static_cast<float>(kLungGain * std::exp(layer * layer_mm_ * kLungGrowth_perMm)) *
                                         at(double(layer) * Vec3{23, 11, 37}, kLungFiner)
                                   : strength[0];
}

}  // namespace insonate
