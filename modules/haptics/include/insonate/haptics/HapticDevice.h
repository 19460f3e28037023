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
  kAbsent,     ///< known, but not there (or not asked for yet)
  kOpening,    ///< found, being opened
  kReady,      ///< open; nothing heard yet
  kStreaming,  ///< its states come
  kLost,       ///< was there; unplugged, or silent. It is taken back as soon as it can be
  kFailed,     ///< cannot be used; trouble() says why and what to do
};

std::string_view nameOf(DevicePhase phase);

/// Identity and limits of a device; constant.
struct DeviceInfo {
  std::string id;    ///< the same each time this device is plugged in, where it can be told: for assignments
  std::string name;  ///< for people
  DeviceKind kind = DeviceKind::kMotion;
  DeviceLimits limits;
};

/// Counts of reports and forces since the start.
struct DeviceCounters {
  std::uint64_t reports = 0, forces = 0;  ///< taken, sent
  std::uint64_t refused = 0;              ///< reports that were too short, too long or unknown
  std::uint64_t lateForces = 0;           ///< that took longer than two periods to send
};

/// Something that a user should hear of, once.
struct DeviceEvent {
  std::int64_t time_ns = 0;  ///< CLOCK_MONOTONIC
  std::string device;        ///< DeviceInfo::id
  DevicePhase phase = DevicePhase::kAbsent;
  bool trouble = false;  ///< a fault, as against news
  std::string text;      ///< a sentence
};

/// A hand or a pedal of any kind: USB, a vendor's kit, mouse and keys, a recording, a model. States arrive and forces
/// leave on the device's own thread: take() and push() never wait, lock or allocate.
class HapticDevice {
 public:
  virtual ~HapticDevice() = default;

  virtual const DeviceInfo& info() const noexcept = 0;
  virtual DevicePhase phase() const noexcept = 0;
  /// Why it is lost or failed, and what to do; else empty. Not for the servo's thread.
  virtual std::string trouble() const = 0;
  virtual DeviceCounters counters() const noexcept = 0;

  /// One thread, the servo's: the latest state, where there is one that was not taken yet.
  virtual bool take(DeviceState& state) noexcept = 0;
  /// Sets the force from now on, in the device's frame; call on the thread of take(). It is limited to the device's
  /// maximum and sent as zero when nothing was pushed for 100 ms. A device receives nothing before the first push.
  virtual void push(const Force& force) noexcept = 0;

  /// The device is in its home posture now: counts are taken from here. For devices without encoders: nothing.
  virtual void calibrate() {}
};

/// Forces older than this are no forces any more.
inline constexpr std::int64_t kForceLife_ns = 100'000'000;

/// `force` within `limits`: no longer than they allow, nothing on axes that are not driven, nothing that is not finite.
Force heldWithin(const DeviceLimits& limits, const Force& force) noexcept;

}  // namespace insonate
