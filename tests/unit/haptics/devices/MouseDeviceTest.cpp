#include <insonate/haptics/MouseDevice.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace insonate;

namespace {

class InputHandTest : public testing::Test {
 protected:
  InputHandTest() {
    hand.setConnected(true);
    after(1);
  }
  /// State that the servo has taken after this many ticks of a millisecond.
  DeviceState after(int ticks) {
    for (; ticks > 0; --ticks) hand.pollAt(now_ns += 1'000'000, state);
    return state;
  }

  MouseDevice hand{"mouse:1", "Mouse"};
  std::int64_t now_ns = 1'000'000'000;
  DeviceState state;
};

TEST_F(InputHandTest, IsAbsentUntilHeldAndStreamsOnceTaken) {
  MouseDevice other("mouse:2", "Mouse");
  EXPECT_EQ(other.phase(), DevicePhase::kAbsent);
  EXPECT_FALSE(other.pollState(state));
  other.setConnected(true);
  EXPECT_EQ(other.phase(), DevicePhase::kReady);
  EXPECT_TRUE(other.pollState(state));
  EXPECT_EQ(other.phase(), DevicePhase::kStreaming);
  EXPECT_GT(state.time_ns, 0);
  other.setConnected(false);
  EXPECT_FALSE(other.pollState(state));
  EXPECT_EQ(other.info().limits.forceAxes, 0);
}

TEST_F(InputHandTest, FollowsADragToItsEndWithoutAStep) {
  for (int i = 0; i < 10; ++i) hand.moveBy({1, 0, -2});  // more than the servo looks
  after(1);
  EXPECT_LT(norm(state.deviceFromStylus.offset), 1);
  EXPECT_GT(state.velocity_mmps.x, 0);
  const DeviceState end = after(400);
  EXPECT_NEAR(norm(end.deviceFromStylus.offset - Vec3{10, 0, -20}), 0, 0.01);
  EXPECT_NEAR(norm(end.velocity_mmps), 0, 1);
}

TEST_F(InputHandTest, TurnsAddUpAndStayARotation) {
  for (int i = 0; i < 900; ++i) hand.turnBy({0, std::numbers::pi / 1800, 0});
  const DeviceState end = after(400);
  const auto& c = end.deviceFromStylus.linear.column;
  // A quarter turn about y brings z to x.
  EXPECT_NEAR(norm(c[2] - Vec3{1, 0, 0}), 0, 1e-3);
  EXPECT_NEAR(determinant(end.deviceFromStylus.linear), 1, 1e-12);
  EXPECT_NEAR(dot(c[0], c[1]), 0, 1e-12);
}

TEST_F(InputHandTest, KeysGlideUntilTheyAreLetGo) {
  hand.setVelocity({100, 0, 0}, {});
  const DeviceState gone = after(200);
  EXPECT_NEAR(gone.velocity_mmps.x, 100, 1);
  hand.setVelocity({}, {});
  const double x = after(300).deviceFromStylus.offset.x;
  EXPECT_GT(x, 10);
  EXPECT_NEAR(after(50).deviceFromStylus.offset.x, x, 0.01);
}

TEST_F(InputHandTest, StopsAtTheEdgeOfItsWorkspace) {
  hand.moveBy({0, 1e6, 0});
  EXPECT_NEAR(after(400).deviceFromStylus.offset.y, MouseDevice::kWorkspace_mm / 2, 0.01);
  hand.moveBy({0, -10, 0});  // comes back at once, not after a million
  EXPECT_NEAR(after(400).deviceFromStylus.offset.y, MouseDevice::kWorkspace_mm / 2 - 10, 0.01);
}

TEST_F(InputHandTest, TheWorkspaceLiesAroundTheLastPlace) {
  hand.placeAt({Mat3{}, {0, 1000, 0}});
  hand.moveBy({0, -50, 0});
  EXPECT_NEAR(after(400).deviceFromStylus.offset.y, 950, 0.01);
  hand.moveBy({0, 1e6, 0});
  EXPECT_NEAR(after(400).deviceFromStylus.offset.y, 1000 + MouseDevice::kWorkspace_mm / 2, 0.01);
}

TEST_F(InputHandTest, ButtonsGoUpWhenItIsLaidDown) {
  hand.setButton(0, true);
  hand.setButton(3, true);
  hand.setButton(0, false);
  hand.setButton(40, true);
  after(1);
  EXPECT_EQ(state.buttons, 8U);
  hand.setConnected(false);
  hand.setConnected(true);
  after(1);
  EXPECT_EQ(state.buttons, 0U);
}

TEST_F(InputHandTest, APlaceIsTakenAtOnce) {
  hand.moveBy({5, 5, 5});
  hand.placeAt({Mat3{}, {1, 2, 3}});
  after(1);
  EXPECT_NEAR(norm(state.deviceFromStylus.offset - Vec3{1, 2, 3}), 0, 1e-9);
  EXPECT_NEAR(norm(state.velocity_mmps), 0, 1e-6);
  hand.moveBy({NAN, 0, 0});
  EXPECT_TRUE(isFinite(after(20).deviceFromStylus.offset));
}

TEST(MouseDevice, WhatComesAfterAPlaceCountsFromThereAlsoWhereBothAreSeenAtOnce) {
  MouseDevice hand("mouse:1", "Mouse");
  hand.setConnected(true);
  hand.moveBy({50, 0, 0});
  hand.placeAt({{}, {10, 0, 0}});
  hand.moveBy({0, 3, 0});
  DeviceState state;
  for (int tick = 1; tick < 1000; ++tick) hand.pollAt(tick * 1'000'000, state);
  EXPECT_NEAR(norm(state.deviceFromStylus.offset - Vec3{10, 3, 0}), 0, 1e-6);
}

}  // namespace
