#pragma once

#include <insonate/core/Vec3.h>

namespace insonate {

/// Force and torque of a device on its stylus, about the stylus's origin. The frame is that of the pose to which the
/// force belongs: for a driver the device's frame, for a virtual tool the patient's.
struct Force {
  Vec3 force_N;
  Vec3 torque_Nmm;  ///< for devices with six force axes
};

}  // namespace insonate
