#include <insonate/haptics/Gamepad.h>

#define SDL_MAIN_HANDLED
#include <SDL.h>
#include <gtest/gtest.h>

#include <functional>

using namespace insonate;
using namespace std::chrono_literals;

namespace {

bool waitFor(const std::function<bool()>& done) {
  for (int i = 0; i < 1000; ++i) {
    if (done()) return true;
    std::this_thread::sleep_for(5ms);
  }
  return false;
}

/// A controller that the test plugs in, holds and feels.
struct Pad {
  std::mutex mutex;
  bool isConnected = false;
  GamepadReading held;
  double felt = 0;
};

class FakePort : public GamepadPort {
 public:
  explicit FakePort(std::shared_ptr<Pad> pad) : pad_(std::move(pad)) {}
  Result<void> open() override { return {}; }
  bool read(GamepadReading& reading, std::string& name) override {
    const std::lock_guard lock(pad_->mutex);
    reading = pad_->held, name = "Fake";
    return pad_->isConnected;
  }
  void rumble(double strength, std::chrono::milliseconds) override {
    const std::lock_guard lock(pad_->mutex);
    pad_->felt = strength;
  }

 private:
  std::shared_ptr<Pad> pad_;
};

TEST(Gamepad, BothHandsComeAndGoWithTheController) {
  const auto pad = std::make_shared<Pad>();
  Gamepads gamepads(std::make_unique<FakePort>(pad));
  const GamepadDevice& left = *gamepads.hands()[0];
  std::this_thread::sleep_for(30ms);
  EXPECT_EQ(left.phase(), DevicePhase::kAbsent);
  {
    const std::lock_guard lock(pad->mutex);
    pad->isConnected = true;
    pad->held.axes[std::size_t(GamepadAxis::RightTrigger)] = 0.5;
    pad->held.buttons = 1U << unsigned(GamepadButton::LeftShoulder);
  }
  ASSERT_TRUE(waitFor([&] { return gamepads.reading().of(GamepadAxis::RightTrigger) == 0.5; }));
  EXPECT_TRUE(gamepads.reading().isDown(GamepadButton::LeftShoulder));
  EXPECT_EQ(gamepads.hands()[1]->phase(), DevicePhase::kStreaming);
  EXPECT_EQ(left.info().kind, DeviceKind::kController);
  EXPECT_EQ(left.quality().quality, 1);
  gamepads.rumble(3, 80ms);
  EXPECT_TRUE(waitFor([&] {
    const std::lock_guard lock(pad->mutex);
    return pad->felt == 1;
  }));
  {
    const std::lock_guard lock(pad->mutex);
    pad->isConnected = false;
  }
  ASSERT_TRUE(waitFor([&] { return left.phase() == DevicePhase::kLost; }));
  EXPECT_NE(left.error(), "");
  EXPECT_EQ(gamepads.reading(), GamepadReading{}) << "a stick that was held does not go on moving the tool";
}

/// SDL itself, with a virtual joystick instead of one on USB.
TEST(Gamepad, SdlReadsAVirtualController) {
  Gamepads gamepads(sdlGamepads());
  ASSERT_TRUE(waitFor([] { return SDL_WasInit(SDL_INIT_GAMECONTROLLER) != 0; }));
  const int index = SDL_JoystickAttachVirtual(SDL_JOYSTICK_TYPE_GAMECONTROLLER, 6, 15, 0);
  if (index < 0) GTEST_SKIP() << "this SDL has no virtual joysticks: " << SDL_GetError();
  SDL_Joystick* joystick = SDL_JoystickOpen(index);
  ASSERT_TRUE(joystick) << SDL_GetError();
  SDL_JoystickSetVirtualAxis(joystick, SDL_CONTROLLER_AXIS_RIGHTX, 16384);
  SDL_JoystickSetVirtualButton(joystick, SDL_CONTROLLER_BUTTON_B, 1);
  EXPECT_TRUE(waitFor([&] { return gamepads.reading().isDown(GamepadButton::East); }));
  EXPECT_NEAR(gamepads.reading().of(GamepadAxis::RightX), 0.5, 0.01);
  EXPECT_NEAR(gamepads.reading().of(GamepadAxis::LeftX), 0, 0.01);
  EXPECT_EQ(gamepads.hands()[0]->phase(), DevicePhase::kStreaming);
  SDL_JoystickClose(joystick);
  SDL_JoystickDetachVirtual(index);
  EXPECT_TRUE(waitFor([&] { return gamepads.hands()[0]->phase() == DevicePhase::kLost; }));
}

}  // namespace
