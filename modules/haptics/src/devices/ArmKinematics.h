#pragma once

#include <insonate/core/Vec3.h>
#include <insonate/haptics/DeviceTable.h>

#include <array>

namespace insonate::haptics {

/// Kinematics of a three-axis haptic arm (ArmTable): position of its end point, and motor currents for a force at this
/// point. Angles: a of the turret about the vertical, b of the upper bar from upright, c of the lower bar from hanging.
/// La is the height of the turret, Lb and Lc are the lengths of the bars. With r = Lb sin b + Lc sin c, the end point
/// lies r cos a toward the user, r sin a to the right, and La + Lb cos b - Lc cos c up.
class ArmKinematics {
 public:
  explicit ArmKinematics(const ArmTable& arm) : arm_(arm) {}

  /// Returns the angles a, b, c in radians from encoder counts, which are 0 in the home posture.
  std::array<double, 3> anglesOf(const std::array<double, 3>& counts) const noexcept;
  /// Returns the position of the end point in the device's frame: origin in the middle of the workspace, x to the
  /// right, y up, z toward the user.
  Vec3 position_mm(const std::array<double, 3>& angles) const noexcept;
  /// Returns the motor currents for a force at the end point; the torques are the transposed Jacobian times the force.
  /// If a motor would exceed its maximum current, all currents are scaled by the same factor.
  std::array<double, 3> currents_mA(const std::array<double, 3>& angles, Vec3 force_N) const noexcept;

 private:
  ArmTable arm_;
};

}  // namespace insonate::haptics
