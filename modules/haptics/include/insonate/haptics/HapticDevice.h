#pragma once

#include <insonate/haptics/DeviceLimits.h>
#include <insonate/haptics/DeviceState.h>
#include <insonate/haptics/DeviceTable.h>
#include <insonate/haptics/Force.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace insonate {

/// Phase of a device's life. A device may pass all phases repeatedly without a restart.
enum class DevicePhase : std::uint8_t {
  kAbsent,     ///< known, but not connected or not yet in use
  kOpening,    ///< found; being opened
  kReady,      ///< open; no report received yet
  kStreaming,  ///< states are arriving
  kLost,       ///< was connected, but is now unplugged or silent; reconnected automatically when possible
  kFailed,     ///< cannot be used; trouble() says why and what to do
};

std::string_view nameOf(DevicePhase phase);

/// Identity and limits of a device; constant.
struct DeviceInfo {
  /// The same each time this device is plugged in, if the device can be identified; for storing assignments.
  std::string id;
  std::string name;  ///< shown to the user
  DeviceKind kind = DeviceKind::kMotion;
  DeviceLimits limits;
};

/// Counts of reports and forces since the start.
struct DeviceCounters {
  std::uint64_t reports = 0, forces = 0;  ///< received, sent
  std::uint64_t refused = 0;              ///< reports that were too short, too long or unknown
  std::uint64_t lateForces = 0;           ///< forces that took longer than two periods to send
};

/// A message to the user about a device, shown once.
struct DeviceEvent {
  std::int64_t time_ns = 0;  ///< CLOCK_MONOTONIC
  std::string device;        ///< DeviceInfo::id
  DevicePhase phase = DevicePhase::kAbsent;
  bool trouble = false;  ///< true: a fault; false: information
  std::string text;      ///< message, one sentence
};

/// A tool or pedal of any kind: on USB, of a vendor's kit, mouse and keys, a recording, or simulated. The device's own
/// thread receives states and sends forces; take() and push() never wait, lock or allocate.
class HapticDevice {
 public:
  virtual ~HapticDevice() = default;

  virtual const DeviceInfo& info() const noexcept = 0;
  virtual DevicePhase phase() const noexcept = 0;
  /// Says why the device is lost or failed, and what to do; else empty. Do not call it on the servo's thread.
  virtual std::string trouble() const = 0;
  virtual DeviceCounters counters() const noexcept = 0;

  /// Gets the latest state; false if there is no new state since the last call. Call it on one thread only, the
  /// servo's.
  virtual bool take(DeviceState& state) noexcept = 0;
  /// Sets the force from now on, in the device's frame; call it on the thread that calls take(). The force is limited
  /// to the device's maximum; it becomes zero if push() is not called for 100 ms. A device receives nothing before the
  /// first push().
  virtual void push(const Force& force) noexcept = 0;

  /// Tells the device that it is in its home posture now, from which its encoders count. No effect on devices without
  /// encoders.
  virtual void calibrate() {}
};

/// Age from which a force is no longer applied.
inline constexpr std::int64_t kForceLife_ns = 100'000'000;

/// Returns `force` within `limits`: magnitudes clamped, zero on axes that are not driven, and zero for values that are
/// not finite.
Force heldWithin(const DeviceLimits& limits, const Force& force) noexcept;

}  // namespace insonate
