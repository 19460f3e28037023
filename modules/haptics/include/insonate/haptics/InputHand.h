#pragma once

#include <insonate/core/Mailbox.h>
#include <insonate/haptics/HapticDevice.h>

#include <atomic>
#include <string>

namespace insonate {

/// A tool or pedal that is controlled by mouse and keys, for users without a device. The window reports motion in
/// millimeters and radians; the servo receives states that follow smoothly, as a hand would move. There is no force
/// feedback.
///
/// Threads: the window's thread calls drag(), turn(), press() and similar functions; the servo's thread calls take()
/// and push(). No function locks, waits or allocates.
class InputHand final : public HapticDevice {
 public:
  /// Time, in s, in which the tool completes most of a jump of the mouse. A jump within less than a frame of the window
  /// would feel jerky.
  static constexpr double kFollow_s = 0.03;
  /// Extent of the workspace around the last placeAt(), mm.
  static constexpr double kWorkspace_mm = 400;

  /// `id` as in DeviceInfo, e.g. "mouse:1".
  InputHand(std::string id, std::string name);

  const DeviceInfo& info() const noexcept override { return info_; }
  DevicePhase phase() const noexcept override { return phase_.load(std::memory_order_acquire); }
  std::string trouble() const override { return {}; }
  DeviceCounters counters() const noexcept override { return {taken_.load(std::memory_order_relaxed), 0, 0, 0}; }
  bool take(DeviceState& state) noexcept override;
  /// Takes the state at a given time (CLOCK_MONOTONIC), which must not decrease; for replays and tests.
  bool takeAt(std::int64_t now_ns, DeviceState& state) noexcept;
  void push(const Force&) noexcept override {}

  /// Takes the tool up or puts it away. Taken up: ready, and streaming after the first take(). Put away: absent, as at
  /// the beginning.
  void hold(bool held) noexcept;
  /// Moves by a distance in the device's frame (DeviceState.h): x to the right, y up, z toward the user.
  void drag(Vec3 by_mm) noexcept;
  /// Turns about the axis `by_rad` (device frame) through the stylus's origin; the length of `by_rad` is the angle.
  void turn(Vec3 by_rad) noexcept;
  /// Sets the velocity for keys that are held down, until the next call.
  void glide(Vec3 velocity_mmps, Vec3 turning_radps) noexcept;
  /// Places the tool there at once, without a path; from then on, the workspace is centered on that place.
  void placeAt(const Transform& deviceFromStylus) noexcept;
  /// Presses or releases a button; the first button is 0.
  void press(int button, bool down) noexcept;

 private:
  /// Total motion since the start: totals lose nothing if the servo misses a message.
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
  Wish wish_;  ///< used by the window's thread
  // Used by the servo's thread.
  Wish seen_;
  Transform target_;
  DeviceState state_;
};

}  // namespace insonate
