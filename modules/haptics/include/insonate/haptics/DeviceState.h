#pragma once

#include <insonate/core/Transform.h>

#include <cstdint>

namespace insonate {

/// State that a device reports at one moment, in its own frame: origin in the middle of its workspace, x to the user's
/// right, y up, z toward the user; mm. The stylus's frame has its origin at the point where the device pushes, and -z
/// along the stylus, away from the hand.
struct DeviceState {
  Transform deviceFromStylus;  ///< rigid
  Vec3 velocity_mmps;          ///< of the stylus's origin; 0 where the device does not tell
  Vec3 angularVelocity_radps;  ///< in the device's frame; 0 where the device does not tell
  std::uint32_t buttons = 0;   ///< one bit a button, the first is bit 0; pressed is 1
  std::int64_t time_ns = 0;    ///< when it was so, CLOCK_MONOTONIC; 0: never
};

}  // namespace insonate
