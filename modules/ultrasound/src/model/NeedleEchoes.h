#pragma once

#include "model/FramePlan.h"

#include <insonate/core/Transform.h>
#include <insonate/ultrasound/Needle.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace insonate {

/// Constants of a steel needle in the beam; the module's README has equations and sources.
namespace steel {
inline constexpr double kImpedance_MRayl = 45, kTissueImpedance_MRayl = 1.63;
inline constexpr double kSpeed_mmPerUs = 5.79;
inline constexpr double kWallShare = 0.17;  ///< of the outer diameter; 0.22 mm of 18 G
/// Per degree of the beam's tilt from square; what the beam loses by spreading over a slope comes on top.
inline constexpr double kTiltLoss_dBpdeg = 0.33;
inline constexpr double kBevel_deg = 20;
/// The edges of the bevel scatter: its echo at the tip, and the most that a tilt takes from it there.
inline constexpr double kTipGain_dB = 6, kTipTiltLoss_dB = 12;
/// Echoes between the near and the far wall: the first over the shaft's, each over the one before.
inline constexpr int kRings = 5;
inline constexpr double kFirstRing = 0.3, kNextRing = 0.5;
}  // namespace steel

/// What a needle does to a frame, for all engines: the echo of its near side on each scanline, and its shadow.
///
/// Gates are those of a scanline's way through tissue: where skin follows the face, they are seen at others (see
/// tissueRange_mm()). Echoes are those of a beam that tissue has not weakened.
class NeedleEchoes {
 public:
  /// Allocates all that frames need. `plan` must outlive this.
  explicit NeedleEchoes(const FramePlan& plan);

  /// Valid (see validate()), or null: none. Allocates nothing.
  void place(const Needle* needle, const Transform& patientFromProbe);
  /// Whether it echoes or casts a shadow in this frame.
  bool present() const { return present_; }

  /// Echoes of one scanline.
  struct Line {
    int first = 0, end = 0;  ///< gates
    float ring_gates = 0;    ///< from ring to ring; 0: none
  };
  const Line& line(int line) const { return lines_[line]; }
  const float* amplitudes(int line) const { return amplitude_.data() + std::size_t(line) * plan_->gates; }

  /// Loss behind the needle, there and back, laid on over one gate, by scanlines; vectors may run past the last.
  const float* shadowOnsets_gate(int plane) const { return onset_gate_.data() + std::size_t(plane) * paddedLines_; }
  const float* shadowLosses_dB(int plane) const { return loss_dB_.data() + std::size_t(plane) * paddedLines_; }
  float shadow_dB(int plane, int line, float tissueGate) const {
    return shadowLosses_dB(plane)[line] * std::clamp(tissueGate - shadowOnsets_gate(plane)[line], 0.0F, 1.0F);
  }

  /// Where a gate lies on the way through tissue.
  float tissueGate(int gate, float gap_mm) const { return static_cast<float>(gate) + gap_mm * gatesPerGap_[gate]; }

  /// Calls `add(gate, amplitude)` with the echoes of a scanline, rings included. `level_dB(gate)`: what is left of the
  /// beam in the middle of a gate, there and back, but for the shadow.
  template <class Level, class Add>
  void addTo(int line, float gap_mm, const Level& level_dB, const Add& add) const {
    const Line& l = lines_[line];
    if (l.first >= l.end) return;
    const int shift = static_cast<int>(std::abs(gap_mm / plan_->gate_mm)) + 2;
    const int last = l.end + shift + static_cast<int>(steel::kRings * l.ring_gates);
    for (int gate = std::max(l.first - shift, 0); gate < std::min(last, plan_->gates); ++gate) {
      const float at = tissueGate(gate, gap_mm);
      float sum = 0, share = 1;
      for (int ring = 0; ring <= (l.ring_gates > 0 ? steel::kRings : 0); ++ring) {
        const float before = static_cast<float>(ring) * l.ring_gates;
        if (const float echo = echoAt(line, at - before); echo > 0)
          sum += share * echo * amplitudeOf(levelAt(level_dB, static_cast<float>(gate) - before));
        share *= static_cast<float>(ring == 0 ? steel::kFirstRing : steel::kNextRing);
      }
      if (sum > 0) add(gate, sum);
    }
  }

 private:
  struct Pose;  ///< in the probe frame

  static float amplitudeOf(float level_dB) { return std::exp2(level_dB * 0.166096404744F); }
  static float mix(float a, float b, float t) { return a + (b - a) * t; }
  float echoAt(int line, float gate) const {
    const float below = std::floor(gate);
    const int g = static_cast<int>(below);
    const auto at = [&](int k) { return k >= lines_[line].first && k < lines_[line].end ? amplitudes(line)[k] : 0.0F; };
    return mix(at(g), at(g + 1), gate - below);
  }
  template <class Level>
  float levelAt(const Level& level_dB, float gate) const {
    const float at = std::clamp(gate, 0.0F, static_cast<float>(plan_->gates - 1)), below = std::floor(at);
    const int g = static_cast<int>(below);
    return mix(level_dB(g), level_dB(std::min(g + 1, plan_->gates - 1)), at - below);
  }

  void echoShaft(const Pose& needle);
  void castShadow(const Pose& needle, int plane, int line);
  /// Spreads an echo over three gates of three scanlines, by quadratic B-splines.
  void add(double scanline, double gate, double amplitude, float ring_gates);

  const FramePlan* plan_;
  std::vector<float> gatesPerGap_;  ///< [gate] by which a millimetre of gap moves tissue
  std::vector<float> amplitude_;    ///< [line][gate]
  std::vector<Line> lines_;
  std::size_t paddedLines_;
  std::vector<float> onset_gate_, loss_dB_;  ///< [plane][padded line]
  bool present_ = false;
};

}  // namespace insonate
