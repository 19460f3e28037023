#pragma once

#include <insonate/core/Vec3.h>

namespace insonate {

/// Force and torque of a device on its stylus, about the stylus's origin. The frame is that of the pose it belongs to:
/// the device's for a driver, the patient's for a virtual tool.
struct Force {
  Vec3 force_N;
  Vec3 torque_Nmm;  ///< for devices with six force axes
};

}  // namespace insonate
