#pragma once

#include "model/FramePlan.h"
#include "scene/TissueField.h"

#include <insonate/core/Transform.h>
#include <insonate/image/PlaneDisplacement.h>
#include <insonate/ultrasound/Instruments.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

namespace insonate {

/// Constants of a steel needle in the beam; the module's README has equations and sources.
namespace steel {
inline constexpr double kImpedance_MRayl = 45, kTissueImpedance_MRayl = 1.63;
inline constexpr double kSpeed_mmPerUs = 5.79;
/// Thickness of the needle's wall as a share of the outer diameter; 0.22 mm for 18 G.
inline constexpr double kWallShare = 0.17;
/// Loss of the shaft's echo per degree between the beam and the perpendicular to the shaft, in addition to the loss by
/// spreading the echo over a slope.
inline constexpr double kTiltLoss_dBpdeg = 0.375;
inline constexpr double kBevel_deg = 20;
/// Echo of the bevel's edges, which scatter in all directions: gain at the tip, maximum loss by tilt of the beam, and
/// length along the shaft.
inline constexpr double kTipGain_dB = 8.5, kTipTiltLoss_dB = 12, kTip_mm = 0.8;
/// Number of rings, echoes that go back and forth between the near and the far wall of the needle. kFirstRing:
/// amplitude of the first ring relative to the shaft's echo; kNextRing: of each further ring relative to the one
/// before.
inline constexpr int kRings = 5;
inline constexpr double kFirstRing = 0.2, kNextRing = 0.4;
}  // namespace steel

/// Constants of guidewires and catheters in the beam; the module's README has equations and sources.
namespace rods {
/// A coil scatters: its echo falls less with tilt than that of a smooth needle, and not below a level.
inline constexpr double kCoilTiltLoss_dBpdeg = 0.2, kCoilMaxTiltLoss_dB = 12;
/// Comet tail behind a coil: amplitude for each gate relative to the echo, decay with depth, length, distance of bands.
inline constexpr double kTailShare = 0.018, kTailDecay_dBpmm = 5, kTail_mm = 12, kTailBand_mm = 0.55;
/// Polyurethane or polyethylene that is filled to be radiopaque.
inline constexpr double kPolymerImpedance_MRayl = 2.2;
}  // namespace rods

/// Returns the point of a needle's axis that moves with the tissue when skin is drawn to the face: the tip or, if the
/// tip is far from the image plane, the point nearest to the plane. All positions are in the probe frame; `sliceSd_mm`
/// is the standard deviation of the slice profile.
Vec3 visiblePoint_mm(Vec3 tip_mm, Vec3 direction, double length_mm, double sliceSd_mm);

/// Effect of a needle, of guidewires, of catheters and of bubbles on a frame, for all engines: their echoes on each
/// scanline, and the shadows of needle and guidewires. The echoes do not include the attenuation by tissue.
///
/// If the skin follows the face (see Contact.h), the whole needle is moved by the shift of the tissue at its tip: the
/// needle stays straight, and its tip stays in the same tissue.
class NeedleEchoes {
 public:
  /// Allocates all memory for frames. `plan` must outlive this object.
  explicit NeedleEchoes(const FramePlan& plan);

  /// Computes echoes and shadows of valid instruments (see validate()) for a frame. Allocates nothing.
  void place(const Instruments& instruments, const TissueField& field, const Transform& patientFromProbe,
             const PlaneDisplacement& displacement);
  /// Tells whether an instrument echoes or casts a shadow in this frame.
  bool present() const { return present_; }

  /// Extent of the needle's echoes on one scanline.
  struct Line {
    int first = 0, end = 0;  ///< first gate with an echo, and the gate after the last
    float ring_gates = 0;    ///< distance between rings (echoes between the needle's walls), in gates; 0: no rings
  };
  const Line& line(int line) const { return lines_[line]; }
  const float* amplitudes(int line) const { return amplitude_.data() + std::size_t(line) * plan_->gates; }

  /// Returns, for each scanline of an elevation plane, the gate (fractional) at which the needle's shadow begins. The
  /// two-way loss rises to its full value within one gate. SIMD vectors may read past the last scanline.
  const float* shadowOnsets_gate(int plane) const { return onset_gate_.data() + std::size_t(plane) * paddedLines_; }
  const float* shadowLosses_dB(int plane) const { return loss_dB_.data() + std::size_t(plane) * paddedLines_; }
  float shadow_dB(int plane, int line, int gate) const {
    const float behind = static_cast<float>(gate) - shadowOnsets_gate(plane)[line];
    return shadowLosses_dB(plane)[line] * std::clamp(behind, 0.0F, 1.0F);
  }

  /// Calls `add(gate, amplitude)` for each echo of the needle on a scanline, including rings. `level_dB(gate)` is the
  /// two-way level of the beam in the middle of a gate, without the needle's shadow.
  template <class Level, class Add>
  void addTo(int line, const Level& level_dB, const Add& add) const {
    const Line& l = lines_[line];
    if (l.first >= l.end) return;
    const int rings = l.ring_gates > 0 ? steel::kRings : 0;
    const int end = std::min(l.end + 1 + static_cast<int>(static_cast<float>(rings) * l.ring_gates), plan_->gates);
    for (int gate = l.first; gate < end; ++gate) {
      float sum = 0, share = 1;
      for (int ring = 0; ring <= rings; ++ring) {
        const float from = static_cast<float>(gate) - static_cast<float>(ring) * l.ring_gates;
        if (const float echo = between(from, [&](int g) { return echoAt(line, g); }); echo > 0)
          sum += share * echo * amplitudeOf(between(std::max(from, 0.0F), level_dB));
        share *= static_cast<float>(ring == 0 ? steel::kFirstRing : steel::kNextRing);
      }
      if (sum > 0) add(gate, sum);
    }
  }

 private:
  struct Pose;  ///< pose of the needle in the probe frame

  static float amplitudeOf(float level_dB) { return std::exp2(level_dB * 0.166096404744F); }
  float echoAt(int line, int gate) const {
    return gate >= lines_[line].first && gate < lines_[line].end ? amplitudes(line)[gate] : 0.0F;
  }
  /// Interpolates values linearly between gates; constant beyond the last gate.
  template <class Values>
  float between(float gate, const Values& values) const {
    const float below = std::floor(gate);
    const int g = static_cast<int>(below);
    const float a = values(g), b = values(std::min(g + 1, plan_->gates - 1));
    return a + (b - a) * (gate - below);
  }

  /// Returns the shift along the beam of the tissue at the needle's visiblePoint_mm().
  Vec3 drawn_mm(const Pose& needle, const TissueField& field, const Transform& patientFromProbe,
                const PlaneDisplacement& displacement) const;
  void placeNeedle(const Needle& needle, const TissueField& field, const Transform& patientFromProbe,
                   const PlaneDisplacement& displacement);
  void echoShaft(const Pose& needle);
  void castShadow(const Pose& needle, int plane, int line);
  /// Spreads an echo over three gates of three scanlines, with quadratic B-splines. An echo of a rod has no rings
  /// (`ring_gates` empty).
  void add(double scanline, double gate, double amplitude, std::optional<float> ring_gates,
           std::vector<float>* tail = nullptr);
  /// Returns the place in the probe frame at which the image shows tissue. Its y is that of the tissue at rest.
  Vec3 shown_mm(Vec3 rest_mm, const TissueField& field, const Transform& patientFromProbe,
                const PlaneDisplacement& displacement) const;
  void echoBubble(const Bubble& bubble, Vec3 shown_mm);
  /// Echoes of one rod; those of a coil also go to `tail_`.
  void echoRod(const FlexibleRod& rod, const Transform& patientFromProbe, const TissueField& field,
               const PlaneDisplacement& displacement);
  struct RodStep;
  void echoRodStep(const RodStep& step);
  void shadeRodStep(const RodStep& step);
  /// Adds the comet tails of the coils in `tail_`, and empties it.
  void addTails();

  const FramePlan* plan_;
  std::vector<float> amplitude_;  ///< amplitude of the needle's echo, [line][gate]
  std::vector<Line> lines_;
  std::vector<float> tail_;     ///< echoes of coils, [line][gate]; empty between frames
  std::vector<int> tailFirst_;  ///< first gate of each line in `tail_`
  std::size_t paddedLines_;
  std::vector<float> onset_gate_, loss_dB_;  ///< onset and loss of the needle's shadow, [plane][padded line]
  bool present_ = false;
};

}  // namespace insonate
