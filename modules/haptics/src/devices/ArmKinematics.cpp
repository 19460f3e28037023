#include "ArmKinematics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace insonate::haptics {
namespace {

/// Arm axes: toward the user, to the right, up. Device axes: right, up, toward the user.
Vec3 deviceFromArm(Vec3 arm) {
  return {arm.y, arm.z, arm.x};
}
Vec3 armFromDevice(Vec3 device) {
  return {device.z, device.x, device.y};
}

}  // namespace

std::array<double, 3> ArmKinematics::anglesOf(const std::array<double, 3>& counts) const noexcept {
  std::array<double, 3> angles{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double turns = counts[i] / arm_.countsPerTurn[i] * arm_.bodyTurnsPerMotorTurn[i];
    angles[i] = arm_.homeAngle_deg[i] * std::numbers::pi / 180 + 2 * std::numbers::pi * turns;
  }
  return angles;
}

Vec3 ArmKinematics::position_mm(const std::array<double, 3>& angles) const noexcept {
  const auto [a, b, c] = angles;
  const auto [la, lb, lc] = arm_.length_mm;
  const double reach = lb * std::sin(b) + lc * std::sin(c);
  const Vec3 end{reach * std::cos(a), reach * std::sin(a), la + lb * std::cos(b) - lc * std::cos(c)};
  return deviceFromArm(end - arm_.center_mm);
}

std::array<double, 3> ArmKinematics::currents_mA(const std::array<double, 3>& angles, Vec3 force_N) const noexcept {
  const auto [a, b, c] = angles;
  const double lb = arm_.length_mm[1], lc = arm_.length_mm[2];
  const double reach = lb * std::sin(b) + lc * std::sin(c);
  const Vec3 out{std::cos(a), std::sin(a), 0}, around{-std::sin(a), std::cos(a), 0}, up{0, 0, 1};
  const std::array<Vec3, 3> wayPerAngle{around * reach, out * (lb * std::cos(b)) - up * (lb * std::sin(b)),
                                        out * (lc * std::cos(c)) + up * (lc * std::sin(c))};
  const Vec3 force = armFromDevice(force_N);
  std::array<double, 3> current{};
  double most = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    current[i] = dot(wayPerAngle[i], force) * arm_.bodyTurnsPerMotorTurn[i] / arm_.torque_NmmPermA[i];
    most = std::max(most, std::abs(current[i]));
  }
  if (most > arm_.maxCurrent_mA)
    for (double& i : current) i *= arm_.maxCurrent_mA / most;
  return current;
}

}  // namespace insonate::haptics
