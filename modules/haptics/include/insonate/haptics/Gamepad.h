#pragma once

#include <insonate/core/Mailbox.h>
#include <insonate/core/Result.h>
#include <insonate/haptics/HapticDevice.h>

#include <array>
#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

namespace insonate {

/// Beginning of DeviceInfo::id of every hand of a game controller.
inline constexpr const char* kGamepadIds = "gamepad:";

/// Axes of a game controller as indices of GamepadReading::axes.
enum class GamepadAxis : std::uint8_t { LeftX, LeftY, RightX, RightY, LeftTrigger, RightTrigger };
/// Buttons as bits of GamepadReading::buttons, named by their places on the controller.
enum class GamepadButton : std::uint8_t {
  South,
  East,
  West,
  North,
  Back,
  Guide,
  Start,
  LeftStick,
  RightStick,
  LeftShoulder,
  RightShoulder,
  Up,
  Down,
  Left,
  Right
};

/// Sticks, triggers and buttons at one moment. Sticks are -1 to 1, positive to the right and down; triggers are 0 to 1.
struct GamepadReading {
  std::array<double, 6> axes{};
  std::uint32_t buttons = 0;

  double of(GamepadAxis axis) const { return axes[std::size_t(axis)]; }
  bool isDown(GamepadButton button) const { return (buttons >> unsigned(button)) & 1; }
  bool operator==(const GamepadReading&) const = default;
};

/// Access to the game controllers of the system. All functions are called on one thread.
class GamepadPort {
 public:
  virtual ~GamepadPort() = default;
  /// Starts the library that reads controllers.
  virtual Result<void> open() = 0;
  /// Reads the first controller that is connected. Returns false if there is none.
  virtual bool read(GamepadReading& reading, std::string& name) = 0;
  /// Lets the controller vibrate; `strength` is 0 to 1.
  virtual void rumble(double strength, std::chrono::milliseconds duration) = 0;
};

/// Returns the controllers that SDL 2 knows.
std::unique_ptr<GamepadPort> sdlGamepads();

/// One half of a game controller: a stick, a trigger and a shoulder button, for one hand. It moves a tool in the way in
/// which keys do, along the skin and the axes of the tool. Therefore it reports no pose to the force loop: pollState()
/// always returns false.
class GamepadDevice final : public HapticDevice {
 public:
  GamepadDevice(std::string id, std::string name);

  const DeviceInfo& info() const noexcept override { return info_; }
  DevicePhase phase() const noexcept override { return phase_; }
  std::string error() const override;
  DeviceCounters counters() const noexcept override { return {readings_, 0, 0, 0}; }
  DeviceQuality quality() const override;
  bool pollState(DeviceState&) noexcept override { return false; }
  void push(const Force&) noexcept override {}

  /// Sets the phase, with the sentence for the user; called by Gamepads.
  void setPhase(DevicePhase phase, std::string sentence = {});
  void countReading() { ++readings_; }

 private:
  const DeviceInfo info_;
  std::atomic<DevicePhase> phase_ = DevicePhase::kAbsent;
  std::atomic<std::uint64_t> readings_ = 0;
  mutable std::mutex mutex_;  ///< guards sentence_
  std::string sentence_;
};

/// Reads a game controller on a thread of its own, a hundred and twenty-five times a second. All functions may be
/// called on any thread.
class Gamepads {
 public:
  static constexpr std::chrono::milliseconds kInterval{8};

  /// Begins to look for a controller.
  explicit Gamepads(std::unique_ptr<GamepadPort> port);

  /// Hands of the controller: left, right. They exist even if no controller is connected.
  const std::array<std::shared_ptr<GamepadDevice>, 2>& hands() const { return hands_; }
  /// Returns the latest reading; sticks at rest and no button if no controller is connected.
  GamepadReading reading() const;
  /// Lets the controller vibrate; the latest call replaces earlier ones. `strength` is 0 to 1.
  void rumble(double strength, std::chrono::milliseconds duration);

 private:
  struct Rumble {
    double strength = 0;
    std::chrono::milliseconds duration{0};
  };
  void run(const std::stop_token& stop);
  void setPhases(DevicePhase phase, const std::string& sentence);

  std::unique_ptr<GamepadPort> port_;  ///< used by the thread
  std::array<std::shared_ptr<GamepadDevice>, 2> hands_;
  mutable std::mutex mutex_;  ///< guards reading_
  GamepadReading reading_;
  Mailbox<Rumble> rumbles_;
  std::jthread thread_;  // declared last, since the thread uses the other members
};

}  // namespace insonate
