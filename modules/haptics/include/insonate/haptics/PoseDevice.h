#pragma once

#include <insonate/core/Mailbox.h>
#include <insonate/haptics/HapticDevice.h>

#include <atomic>
#include <mutex>
#include <string>

namespace insonate {

/// Device without motors whose states another thread measures, several to some hundred times a second: a printed body
/// before a camera, or a tracker. The force loop receives a state in each tick: the latest pose, extrapolated with its
/// velocity to the present time. When a new state contradicts the extrapolation, the difference is removed smoothly
/// within about one interval between two states, so that the tool does not jump 30 times a second. If no more states
/// arrive, the tool stays where it is.
///
/// Threads: one thread calls post(), setPhase() and setQuality(); the force loop's thread calls pollState() and push(),
/// which neither lock, wait nor allocate.
class PoseDevice final : public HapticDevice {
 public:
  /// Longest time over which a pose is extrapolated, ns.
  static constexpr std::int64_t kMostAhead_ns = 50'000'000;

  /// `id` and `name`: see DeviceInfo. `rate_Hz`: nominal number of states per second. `workspace_mm`: see DeviceLimits.
  PoseDevice(std::string id, std::string name, double rate_Hz, Vec3 workspace_mm,
             DeviceKind kind = DeviceKind::kTracker);

  const DeviceInfo& info() const noexcept override { return info_; }
  DevicePhase phase() const noexcept override { return phase_.load(std::memory_order_acquire); }
  std::string error() const override;
  DeviceCounters counters() const noexcept override { return {posted_.load(std::memory_order_relaxed), 0, 0, 0}; }
  DeviceQuality quality() const override;
  /// Copies the pose at the present time. Returns false before the first post(), and while the phase is not kStreaming.
  bool pollState(DeviceState& state) noexcept override;
  /// Does the same as pollState(), for the time `now_ns` (CLOCK_MONOTONIC) instead of the present time; for replays and
  /// tests. The time must not decrease from call to call.
  bool pollAt(std::int64_t now_ns, DeviceState& state) noexcept;
  void push(const Force&) noexcept override {}

  /// Posts a state that was measured; the phase becomes kStreaming. DeviceState::time_ns is the time at which the
  /// device had this pose, so that a delay of the measurement is extrapolated, too. A state that is not finite is
  /// ignored. For a device that is out of sight, post its last pose with velocity 0.
  void post(const DeviceState& measured) noexcept;
  /// Sets the phase, and the sentence that says why the device is lost or has failed. The first state after a phase
  /// other than kStreaming is taken without a transition.
  void setPhase(DevicePhase phase, std::string sentence = {});
  void setQuality(DeviceQuality quality);

 private:
  struct Measured {
    DeviceState state;
    std::uint32_t gaps = 0;  ///< number of times that the phase was left before this state
  };

  void take(const Measured& measured) noexcept;
  void extrapolate(std::int64_t now_ns) noexcept;

  const DeviceInfo info_;
  std::atomic<DevicePhase> phase_{DevicePhase::kAbsent};
  std::atomic<std::uint64_t> posted_{0};
  Mailbox<Measured> states_;
  std::uint32_t gaps_ = 0;    ///< used by the thread that posts
  mutable std::mutex mutex_;  ///< guards sentence_ and quality_
  std::string sentence_;
  DeviceQuality quality_;
  // The following members are used by the force loop's thread.
  Measured last_;
  DeviceState shown_;
  Vec3 off_mm_, off_rad_;  ///< difference between the pose shown before the last state and its extrapolation
  std::int64_t begun_ns_ = 0, blend_ns_ = 0;  ///< begin and duration of the removal of this difference
};

}  // namespace insonate
