#pragma once

#include <insonate/haptics/Force.h>
#include <insonate/haptics/LocalModel.h>

namespace insonate::haptics {

/// Force of the skin on the probe in patient space, with the torque about the origin of the probe's frame.
struct SkinForce {
  Force force;
  double axial_N = 0, deepest_mm = 0;
};

/// Contact of the probe with skin. Each of some points of the face has a proxy that stays on its patch of skin
/// (Ruspini, Kolarov and Khatib 1997); a spring and a damper connect point and proxy. The skin at each point is a plane
/// (SkinPatch), so that the proxy is the foot of the perpendicular, and lags along the skin due to friction.
class ProbeContact {
 public:
  void reset() { *this = {}; }
  SkinForce press(const LocalModel& model, const Transform& patientFromProbe, double steepest_Npmm, double friction,
                  double step_s) noexcept;

 private:
  void take(const LocalModel& model, double step_s);

  std::array<SkinPatch, 4> patches_;
  int count_ = 0;
  std::array<Vec3, 4> anchor_mm_{};
  std::array<double, 4> depth_mm_{};
  std::array<bool, 4> touches_{};
};

}  // namespace insonate::haptics
