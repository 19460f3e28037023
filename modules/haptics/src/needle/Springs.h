#pragma once

#include <algorithm>
#include <cmath>

/// Force laws of needle and tissue. They depend on positions and not on time, so that none returns more energy than it
/// received.
namespace insonate::haptics {

/// Force k1 d + k2 d^2 of a wall (surface of a structure) against the needle's tip before puncture (Okamura, Simone and
/// O'Leary, IEEE Trans Biomed Eng 2004;51:1707). The force continues linearly from the depth at which its slope reaches
/// the maximum that the haptic device can render.
struct Stiffening {
  double k1_Npmm = 0, k2_Npmm2 = 0, steepest_Npmm = 1e9;

  double force_N(double d_mm) const {
    if (d_mm <= 0) return 0;
    const double k1 = std::min(k1_Npmm, steepest_Npmm);
    if (k2_Npmm2 <= 0) return k1 * d_mm;
    const double straight_mm = (steepest_Npmm - k1) / (2 * k2_Npmm2);
    if (d_mm <= straight_mm) return (k1 + k2_Npmm2 * d_mm) * d_mm;
    return (k1 + k2_Npmm2 * straight_mm) * straight_mm + steepest_Npmm * (d_mm - straight_mm);
  }
};

/// Stiffness of a wall (e.g. the skin) that the needle's tip drags sideways.
inline constexpr double kAside_Npmm = 0.2;

/// Cutting resistance of tissue. The tissue yields like a spring in front of the needle's tip until it is cut, and
/// stays cut. The resistance acts against insertion only.
class CutFront {
 public:
  void restart(double s_mm) { uncut_mm_ = s_mm; }
  /// Returns the resistance when the tip is at depth `s_mm`.
  double force_N(double s_mm, double cutting_N, double stiffness_Npmm) {
    if (stiffness_Npmm <= 0 || cutting_N <= 0) {
      uncut_mm_ = std::max(uncut_mm_, s_mm);
      return 0;
    }
    uncut_mm_ = std::max(uncut_mm_, s_mm - cutting_N / stiffness_Npmm);
    return stiffness_Npmm * std::max(0.0, s_mm - uncut_mm_);
  }

 private:
  double uncut_mm_ = 0;
};

/// Stick-slip friction in terms of displacement alone (Hayward and Armstrong, A new computational model of friction
/// applied to haptic rendering, 2000). As in Karnopp's model (J Dyn Syst Meas Control 1985;107:100) there are two
/// levels of force, and a band of speed within which the needle sticks; while it sticks, a spring replaces the unknown
/// force.
class StickSlip {
 public:
  void restart(double s_mm) {
    anchor_mm_ = s_mm;
    sticks_ = true;
  }
  /// Returns the friction force at depth `s_mm`, positive against insertion. `slides_N`: sliding friction; `holds_N`:
  /// static friction, at least `slides_N`. The speed only decides whether the needle sticks again.
  double force_N(double s_mm, double speed_mmps, double slides_N, double holds_N, double stiffness_Npmm) {
    if (stiffness_Npmm <= 0 || holds_N <= 0) {
      restart(s_mm);
      return 0;
    }
    const double stretched_N = stiffness_Npmm * (s_mm - anchor_mm_);
    if (sticks_ && std::abs(stretched_N) > holds_N) sticks_ = false;
    if (!sticks_) {
      if (std::abs(stretched_N) > slides_N) anchor_mm_ = s_mm - std::copysign(slides_N, stretched_N) / stiffness_Npmm;
      if (std::abs(speed_mmps) < kStickSpeed_mmps || speed_mmps * stretched_N < 0) sticks_ = true;
    }
    return stiffness_Npmm * (s_mm - anchor_mm_);
  }
  bool sticks() const { return sticks_; }

 private:
  static constexpr double kStickSpeed_mmps = 1;  // the needle sticks below this speed: Karnopp's band
  double anchor_mm_ = 0;
  bool sticks_ = true;
};

}  // namespace insonate::haptics
