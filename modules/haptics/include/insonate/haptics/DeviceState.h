#pragma once

#include <insonate/core/Transform.h>

#include <cstdint>

namespace insonate {

/// State that a device reports at one moment, in the device frame: origin in the middle of the workspace, x to the
/// user's right, y up, z toward the user; mm. The stylus frame has its origin at the point on which the device's force
/// acts; its -z axis points along the stylus, away from the hand.
struct DeviceState {
  Transform deviceFromStylus;  ///< rigid pose of the stylus in the device frame
  Vec3 velocity_mmps;          ///< velocity of the stylus's origin; 0 if the device does not report it
  Vec3 angularVelocity_radps;  ///< angular velocity of the stylus, device frame; 0 if the device does not report it
  std::uint32_t buttons = 0;   ///< one bit per button, the first button is bit 0; 1: pressed
  /// time at which the device had this state, CLOCK_MONOTONIC; 0: the device has not reported a state yet
  std::int64_t time_ns = 0;
};

}  // namespace insonate
