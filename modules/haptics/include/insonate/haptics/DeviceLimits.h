#pragma once

#include <insonate/core/Vec3.h>

namespace insonate {

/// Capabilities of a haptic device. 0 means that the manufacturer does not state the value; the program then does not
/// use the value.
struct DeviceLimits {
  /// number of axes that the device measures: 0 (a pedal), 3 (position) or 6 (position and direction)
  int sensedAxes = 0;
  /// number of axes along which the device exerts force: 0 (a mouse), 3 (force) or 6 (force and torque)
  int forceAxes = 0;
  Vec3 workspace_mm;             ///< full extent (not half) of the workspace along the device's axes
  double maxForce_N = 0;         ///< peak force
  double continuousForce_N = 0;  ///< force that can be held indefinitely; at most maxForce_N
  double maxTorque_Nmm = 0;      ///< peak torque, for devices with six force axes
  /// Maximum stiffness of a virtual wall that the device can render, according to the manufacturer.
  double maxStiffness_Npmm = 0;
  double rate_Hz = 0;        ///< rate at which the device reports its state and takes forces
  double resolution_mm = 0;  ///< smallest position change that the encoders report
  double damping_Nspm = 0;   ///< viscous damping of the device's mechanics; b in passiveStiffness_Npmm()
  double friction_N = 0;     ///< friction that must be overcome to move the device
  double mass_kg = 0;        ///< apparent mass of the device at the stylus
};

}  // namespace insonate
