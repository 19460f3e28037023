#pragma once

#include <insonate/core/Vec3.h>

namespace insonate {

/// Capabilities of a device. 0 if its maker states none and nothing depends on it.
struct DeviceLimits {
  int sensedAxes = 0;            ///< 0 (a pedal), 3 (position) or 6 (position and direction)
  int forceAxes = 0;             ///< 0 (a mouse), 3 (force) or 6 (force and torque)
  Vec3 workspace_mm;             ///< full extent along the device's axes
  double maxForce_N = 0;         ///< for a moment
  double continuousForce_N = 0;  ///< for as long as one likes; at most maxForce_N
  double maxTorque_Nmm = 0;      ///< with six force axes
  double maxStiffness_Npmm = 0;  ///< of a wall that it can show, according to its maker
  double rate_Hz = 0;            ///< of states and forces
  double resolution_mm = 0;      ///< smallest step of position
  double damping_Nspm = 0;       ///< viscous, of its mechanics: b of Colgate's bound
  double friction_N = 0;         ///< that has to be overcome to move it
  double mass_kg = 0;            ///< that the hand feels at the stylus
};

}  // namespace insonate
