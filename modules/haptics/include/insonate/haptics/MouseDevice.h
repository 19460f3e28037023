#pragma once

#include <insonate/core/Mailbox.h>
#include <insonate/haptics/HapticDevice.h>

#include <atomic>
#include <string>

namespace insonate {

/// Device that mouse and keys emulate, for users without a haptic device. It can move a tool (probe or needle) or act
/// as a pedal. The window reports motion in millimeters and radians; the force loop receives states that follow this
/// motion smoothly. There is no force feedback.
///
/// Threads: the GUI thread calls moveBy(), turnBy(), setButton() and similar functions; the force loop's thread calls
/// pollState() and push(). No function locks, waits or allocates.
class MouseDevice final : public HapticDevice {
 public:
  /// Time constant, in s, with which the tool follows the mouse. A smaller constant makes the motion jerky.
  static constexpr double kFollow_s = 0.03;
  /// Extent of the workspace, whose center is the position set by the last placeAt(), mm.
  static constexpr double kWorkspace_mm = 400;

  /// `id`: see DeviceInfo::id, e.g. "mouse:1". `name`: shown to the user.
  MouseDevice(std::string id, std::string name);

  const DeviceInfo& info() const noexcept override { return info_; }
  DevicePhase phase() const noexcept override { return phase_.load(std::memory_order_acquire); }
  std::string error() const override { return {}; }
  DeviceCounters counters() const noexcept override { return {taken_.load(std::memory_order_relaxed), 0, 0, 0}; }
  DeviceQuality quality() const override { return {1000 * kFollow_s, 1, {}}; }
  bool pollState(DeviceState& state) noexcept override;
  /// Does the same as pollState(), for the time `now_ns` (CLOCK_MONOTONIC) instead of the present time; for replays and
  /// tests. The time must not decrease from call to call.
  bool pollAt(std::int64_t now_ns, DeviceState& state) noexcept;
  void push(const Force&) noexcept override {}

  /// Connects (true) or disconnects (false) the emulated device. The device's phase is kAbsent at the beginning and
  /// while the device is disconnected, kReady once it is connected, and kStreaming after the first pollState().
  void setConnected(bool held) noexcept;
  /// Moves the tool by a distance in the device frame (DeviceState.h): x to the right, y up, z toward the user.
  void moveBy(Vec3 by_mm) noexcept;
  /// Turns the tool about the axis `by_rad` (device frame) through the stylus's origin; the length of `by_rad` is the
  /// angle.
  void turnBy(Vec3 by_rad) noexcept;
  /// Sets the velocity at which the tool moves and turns until the next call, for keys that are held down.
  void setVelocity(Vec3 velocity_mmps, Vec3 turning_radps) noexcept;
  /// Moves the tool to a pose at once, without intermediate poses, and centers the workspace on that pose.
  void placeAt(const Transform& deviceFromStylus) noexcept;
  /// Presses (true) or releases (false) a button; the first button is 0.
  void setButton(int button, bool down) noexcept;

 private:
  /// Message from the GUI thread: total motion since the start. The totals are correct even if the force loop misses a
  /// message.
  struct Wish {
    Vec3 dragged_mm;
    Mat3 turned;
    Vec3 glide_mmps, glide_radps;
    Transform place;
    std::uint32_t places = 0;  ///< number of placeAt() calls
    std::uint32_t buttons = 0;
  };

  void obey(const Wish& wish) noexcept;
  void follow(double step_s) noexcept;

  const DeviceInfo info_;
  std::atomic<DevicePhase> phase_{DevicePhase::kAbsent};
  std::atomic<std::uint64_t> taken_{0};
  Mailbox<Wish> wishes_;
  Wish wish_;  ///< last message sent; used by the GUI thread
  // The following members are used by the force loop's thread.
  Wish seen_;
  Transform target_;
  DeviceState state_;
};

}  // namespace insonate
