#include <insonate/haptics/InputHand.h>

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <numbers>
#include <thread>

using namespace insonate;
using namespace std::chrono_literals;

namespace {

/// As the servo does, for so long.
DeviceState after(InputHand& hand, std::chrono::milliseconds time) {
  DeviceState state;
  for (const auto end = std::chrono::steady_clock::now() + time; std::chrono::steady_clock::now() < end;) {
    hand.take(state);
    std::this_thread::sleep_for(1ms);
  }
  return state;
}

class InputHandTest : public testing::Test {
 protected:
  InputHandTest() { hand.hold(true); }
  InputHand hand{"mouse:1", "Mouse"};
  DeviceState state;
};

TEST_F(InputHandTest, IsAbsentUntilHeldAndStreamsOnceTaken) {
  InputHand other("mouse:2", "Mouse");
  EXPECT_EQ(other.phase(), DevicePhase::kAbsent);
  EXPECT_FALSE(other.take(state));
  other.hold(true);
  EXPECT_EQ(other.phase(), DevicePhase::kReady);
  EXPECT_TRUE(other.take(state));
  EXPECT_EQ(other.phase(), DevicePhase::kStreaming);
  EXPECT_GT(state.time_ns, 0);
  other.hold(false);
  EXPECT_FALSE(other.take(state));
  EXPECT_EQ(other.info().limits.forceAxes, 0);
}

TEST_F(InputHandTest, FollowsADragToItsEndWithoutAStep) {
  hand.take(state);
  for (int i = 0; i < 10; ++i) hand.drag({1, 0, -2});  // more than the servo looks
  std::this_thread::sleep_for(1ms);
  hand.take(state);
  EXPECT_LT(norm(state.deviceFromStylus.offset), 15);
  EXPECT_GT(state.velocity_mmps.x, 0);
  const DeviceState end = after(hand, 400ms);
  EXPECT_NEAR(norm(end.deviceFromStylus.offset - Vec3{10, 0, -20}), 0, 0.01);
  EXPECT_NEAR(norm(end.velocity_mmps), 0, 1);
}

TEST_F(InputHandTest, TurnsAddUpAndStayARotation) {
  hand.take(state);
  for (int i = 0; i < 900; ++i) hand.turn({0, std::numbers::pi / 1800, 0});
  const DeviceState end = after(hand, 400ms);
  const auto& c = end.deviceFromStylus.linear.column;
  // A quarter turn about y brings z to x.
  EXPECT_NEAR(norm(c[2] - Vec3{1, 0, 0}), 0, 1e-3);
  EXPECT_NEAR(determinant(end.deviceFromStylus.linear), 1, 1e-12);
  EXPECT_NEAR(dot(c[0], c[1]), 0, 1e-12);
}

TEST_F(InputHandTest, KeysGlideUntilTheyAreLetGo) {
  hand.take(state);
  hand.glide({100, 0, 0}, {});
  const DeviceState gone = after(hand, 200ms);
  EXPECT_NEAR(gone.velocity_mmps.x, 100, 5);
  hand.glide({}, {});
  const double x = after(hand, 300ms).deviceFromStylus.offset.x;
  EXPECT_GT(x, 10);
  EXPECT_NEAR(after(hand, 50ms).deviceFromStylus.offset.x, x, 0.01);
}

TEST_F(InputHandTest, StopsAtTheEdgeOfItsWorkspace) {
  hand.take(state);
  hand.drag({0, 1e6, 0});
  EXPECT_NEAR(after(hand, 400ms).deviceFromStylus.offset.y, InputHand::kWorkspace_mm / 2, 0.01);
  hand.drag({0, -10, 0});  // comes back at once, not after a million
  EXPECT_NEAR(after(hand, 400ms).deviceFromStylus.offset.y, InputHand::kWorkspace_mm / 2 - 10, 0.01);
}

TEST_F(InputHandTest, ButtonsGoUpWhenItIsLaidDown) {
  hand.press(0, true);
  hand.press(3, true);
  hand.press(0, false);
  hand.press(40, true);
  hand.take(state);
  EXPECT_EQ(state.buttons, 8U);
  hand.hold(false);
  hand.hold(true);
  hand.take(state);
  EXPECT_EQ(state.buttons, 0U);
}

TEST_F(InputHandTest, APlaceIsTakenAtOnce) {
  hand.take(state);
  hand.drag({5, 5, 5});
  hand.placeAt({Mat3{}, {1, 2, 3}});
  hand.take(state);
  EXPECT_NEAR(norm(state.deviceFromStylus.offset - Vec3{1, 2, 3}), 0, 1e-9);
  EXPECT_NEAR(norm(state.velocity_mmps), 0, 1e-6);
  hand.drag({NAN, 0, 0});
  EXPECT_TRUE(isFinite(after(hand, 20ms).deviceFromStylus.offset));
}

}  // namespace
