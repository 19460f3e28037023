#pragma once

#include <insonate/core/Vec3.h>

namespace insonate {

/// Force and torque about the origin of the stylus frame (DeviceState.h) that a haptic device exerts on its stylus. In
/// a device driver both are in the device frame; for a virtual tool (probe or needle) they are in patient space.
struct Force {
  Vec3 force_N;
  Vec3 torque_Nmm;  ///< used only by devices with six force axes
};

}  // namespace insonate
