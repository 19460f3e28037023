#pragma once

#include "model/FramePlan.h"
#include "scene/SceneData.h"

#include <insonate/image/PlaneDisplacement.h>

#include <span>
#include <vector>

namespace insonate {

/// Echoes behind a surface of gas. Only two kinds of echoes arrive from there: the tissue above, mirrored, and rings
/// (echoes that go back and forth between gas and probe), each of which repeats the surface's own echo. The surface is
/// a rough mucosa: the strength of each ring varies along the surface independently.
class Reverberation {
 public:
  /// Number of gates behind the gas surface from which on echoes are replaced, so that the surface keeps its own echo.
  static constexpr int kFirstGate = 2;

  /// Level and decay of the tissue that is mirrored below a lung, in place of kMirrorShare and kMirrorDecay_mm: the
  /// echoes below a pleura fade within centimeters, those behind the mucosa of an airway within millimeters (chosen).
  static constexpr double kLungMirrorShare = 0.25, kLungMirrorDecay_mm = 12;
  /// Factor by which the grains below a lung are finer than the patches of an airway.
  static constexpr int kLungFiner = 5;
  /// Strength of the mirrored tissue below a lung relative to that of an airway: this gain, which grows exponentially
  /// with the depth below the pleura.
  static constexpr double kLungGain = kLungMirrorShare / acoustics::kMirrorShare;
  static constexpr double kLungGrowth_perMm = 1 / acoustics::kMirrorDecay_mm - 1 / kLungMirrorDecay_mm;

  /// A repeated echo: the echo of the gate `gatesAbove` gates above the gas surface is repeated with the factor `share`
  /// and its strength.
  struct Repeat {
    int gatesAbove;
    float share;
    int strength;  ///< index of its strength
  };

  explicit Reverberation(const FramePlan& plan);

  /// Computes the strength of each repeated echo at a point of the gas surface, patient LPS; 1 on average. A lung
  /// slides along the pleura toward the head, unless a pneumothorax has detached it, and the strengths of its echoes
  /// move with it. Below a lung, the mirrored tissue is stronger, and each of its layers has strengths of its own, so
  /// that it is granular.
  void strengthsAt(Vec3 surface_mm, const AcousticScene::Impl& scene, const LungMotion& motion,
                   std::span<float> strength) const;
  /// Returns the number of rings, whose strengths come before those of the layers of the mirrored tissue.
  int rings() const { return rings_; }
  /// Returns the number of strengths.
  int strengths() const { return rings_ + layers_; }

  /// Returns the repeated echoes that arrive at a gate this number of gates behind the gas surface.
  std::span<const Repeat> at(int gatesBehind) const {
    return {repeats_.data() + first_[gatesBehind], repeats_.data() + first_[gatesBehind + 1]};
  }

 private:
  std::vector<Repeat> repeats_;
  std::vector<int> first_;
  int rings_ = 1, layers_ = 1, gatesPerLayer_ = 1;
  double layer_mm_ = 0;
};

}  // namespace insonate
