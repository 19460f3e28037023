#pragma once

#include <insonate/core/Mailbox.h>
#include <insonate/haptics/HapticDevice.h>

#include <atomic>
#include <string>

namespace insonate {

/// A hand or pedal made of mouse and keys, for users without a device. The window reports motion in millimeters and
/// radians; the servo takes states that follow smoothly, as a hand would move. It feels no forces.
///
/// The window's thread: drag(), turn(), press() and so on. The servo's: take(), push(). Nothing here locks, waits or
/// allocates.
class InputHand final : public HapticDevice {
 public:
  /// Time in which most of a jump of the mouse is made up, s: shorter than a frame of the window would feel jerky.
  static constexpr double kFollow_s = 0.03;
  /// Extent of the workspace around the last place, mm.
  static constexpr double kWorkspace_mm = 400;

  /// `id` as in DeviceInfo, e.g. "mouse:1".
  InputHand(std::string id, std::string name);

  const DeviceInfo& info() const noexcept override { return info_; }
  DevicePhase phase() const noexcept override { return phase_.load(std::memory_order_acquire); }
  std::string trouble() const override { return {}; }
  DeviceCounters counters() const noexcept override { return {taken_.load(std::memory_order_relaxed), 0, 0, 0}; }
  bool take(DeviceState& state) noexcept override;
  /// Takes the state at another time (CLOCK_MONOTONIC), which must not decrease: for replays and tests.
  bool takeAt(std::int64_t now_ns, DeviceState& state) noexcept;
  void push(const Force&) noexcept override {}

  /// Takes the tool up or puts it away: ready, then streaming from the first take on; or absent. Starts absent.
  void hold(bool held) noexcept;
  /// Moves by a distance in the device's frame (DeviceState.h): x to the right, y up, z to the user.
  void drag(Vec3 by_mm) noexcept;
  /// Turns about the device's axes through the stylus's origin, by the length of `by_rad`.
  void turn(Vec3 by_rad) noexcept;
  /// Sets the velocity for keys that are held down, until the next call.
  void glide(Vec3 velocity_mmps, Vec3 turning_radps) noexcept;
  /// Puts the tool there at once, without a path between; the workspace lies around that place from then on.
  void placeAt(const Transform& deviceFromStylus) noexcept;
  /// Button 0 is the first.
  void press(int button, bool down) noexcept;

 private:
  /// Sums since the start, so that a wish that is not seen is not lost.
  struct Wish {
    Vec3 dragged_mm;
    Mat3 turned;
    Vec3 glide_mmps, glide_radps;
    Transform place;
    std::uint32_t places = 0;  ///< counts placeAt()
    std::uint32_t buttons = 0;
  };

  void obey(const Wish& wish) noexcept;
  void follow(double step_s) noexcept;

  const DeviceInfo info_;
  std::atomic<DevicePhase> phase_{DevicePhase::kAbsent};
  std::atomic<std::uint64_t> taken_{0};
  Mailbox<Wish> wishes_;
  Wish wish_;  ///< the window's thread
  // The servo's thread.
  Wish seen_;
  Transform target_;
  DeviceState state_;
};

}  // namespace insonate
