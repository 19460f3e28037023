#pragma once

#include <insonate/haptics/DeviceLimits.h>
#include <insonate/haptics/DeviceState.h>
#include <insonate/haptics/DeviceTable.h>
#include <insonate/haptics/Force.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace insonate {

/// Connection state of a device. A device may go through all phases repeatedly while the program runs.
enum class DevicePhase : std::uint8_t {
  kAbsent,     ///< known to the program, but not connected or not yet used
  kOpening,    ///< plugged in; being opened
  kReady,      ///< open; no report received yet
  kStreaming,  ///< states are arriving
  kLost,       ///< was connected, but is now unplugged or silent; reconnected automatically when possible
  kFailed,     ///< cannot be used; HapticDevice::error() says why and what to do
};

std::string_view nameOf(DevicePhase phase);

/// Identity and limits of a device; constant.
struct DeviceInfo {
  /// Identifier under which the assignment of the device to a hand is stored; the same each time the device is plugged
  /// in, if it has a serial number.
  std::string id;
  std::string name;  ///< device name shown to the user
  DeviceKind kind = DeviceKind::kMotion;
  DeviceLimits limits;
};

/// Numbers of reports and forces since the device was first opened.
struct DeviceCounters {
  std::uint64_t reports = 0, forces = 0;  ///< reports received from the device, forces sent to it
  std::uint64_t refused = 0;              ///< reports that were rejected as too short, too long or of unknown id
  std::uint64_t lateForces = 0;           ///< forces whose sending took longer than two periods of the device's rate
};

/// Quality with which a device measures the hand at present.
struct DeviceQuality {
  double latency_ms = 0;  ///< time from the motion of the hand to its state in the program; 0: not measured
  double quality = 1;     ///< 1: as well as the device can; 0: the hand is not measured
  std::string advice;     ///< what the user can do to improve it, one sentence; empty if nothing is wrong
};

/// A message to the user about a device, shown once.
struct DeviceEvent {
  std::int64_t time_ns = 0;  ///< time of the event, CLOCK_MONOTONIC
  std::string device;        ///< device concerned: DeviceInfo::id
  DevicePhase phase = DevicePhase::kAbsent;
  bool error = false;  ///< true: the message reports a fault; false: it only informs
  std::string text;    ///< message for the user, one sentence
};

/// Interface of every hand-held device and pedal: connected by USB, through a vendor's SDK, emulated by mouse and keys,
/// replayed from a recording, or simulated. The device's own thread receives states and sends forces; pollState() and
/// push() only exchange values with it and never wait, lock or allocate.
class HapticDevice {
 public:
  virtual ~HapticDevice() = default;

  /// Returns the identity and the limits of the device.
  virtual const DeviceInfo& info() const noexcept = 0;
  /// Returns the state of the connection to the device.
  virtual DevicePhase phase() const noexcept = 0;
  /// Says why the device is lost or has failed, and what to do; empty if the device works. Do not call this function on
  /// the force loop's thread.
  virtual std::string error() const = 0;
  /// Returns the numbers of reports and forces so far.
  virtual DeviceCounters counters() const noexcept = 0;
  /// Returns how well the device measures the hand. Do not call this function on the force loop's thread.
  virtual DeviceQuality quality() const { return {}; }

  /// Copies the device's latest state into `state`. Returns false, without a copy, if no new state has arrived since
  /// the last call. Call it only on the force loop's thread.
  virtual bool pollState(DeviceState& state) noexcept = 0;
  /// Sets the force that the device exerts from now on, in the device frame. Call it on the thread that calls
  /// pollState(). The force is limited to the device's maximum and becomes zero if push() is not called for 100 ms.
  /// Nothing is sent to the device before the first push().
  virtual void push(const Force& force) noexcept = 0;

  /// Declares that the device is now in its home posture, from which its encoders count. Call it when the user has put
  /// the device there. Has no effect on devices without encoders.
  virtual void calibrate() {}
};

/// Time after the last push() after which a device's force is set to zero.
inline constexpr std::int64_t kForceLife_ns = 100'000'000;

/// Returns `force` reduced to what a device can exert: magnitudes clamped to `limits`, axes without a motor and
/// non-finite values set to zero.
Force limitedForce(const DeviceLimits& limits, const Force& force) noexcept;

}  // namespace insonate
