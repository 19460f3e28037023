#include "PlainSocket.h"

#include <insonate/igtlink/TrackerHand.h>

#include <gmock/gmock.h>

#include <array>
#include <cmath>

namespace insonate {
namespace {

using test::Bytes;
using test::PlainSocket;

/// A tracker on a plain socket.
class TrackerHandTest : public testing::Test {
 protected:
  void begin(const std::string& tool) {
    hand.emplace("127.0.0.1", listening.port(), tool);
    server.emplace(listening.accepted());
    ASSERT_TRUE(server->isOpen());
  }
  bool send(const std::string& name, const Transform& pose) const {
    Bytes body;
    for (const Vec3& column : {pose.linear.column[0], pose.linear.column[1], pose.linear.column[2], pose.offset})
      for (int axis = 0; axis < 3; ++axis) test::putReal(body, static_cast<float>(column[axis]));
    return server->write(test::message(1, "TRANSFORM", name, body));
  }
  DeviceState lastState() const {
    DeviceState state;
    hand->device()->pollState(state);
    return state;
  }

  const PlainSocket listening = PlainSocket::listening();
  std::optional<TrackerHand> hand;
  std::optional<PlainSocket> server;
};

TEST_F(TrackerHandTest, MovesItsDeviceAndLosesIt) {
  begin("StylusToTracker");
  const auto device = hand->device();
  EXPECT_EQ(device->info().name, "Tracker: StylusToTracker");
  ASSERT_TRUE(test::waitUntil([&] { return device->error() == "The tracker has sent no pose yet."; }));
  EXPECT_EQ(device->phase(), DevicePhase::kReady);
  for (int i = 0; i < 30; ++i) {
    ASSERT_TRUE(send("ProbeToTracker", {{}, {100, 0, 0}}));
    ASSERT_TRUE(send("StylusToTracker", {{}, {0.5 * i, 20, 30}}));
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  ASSERT_TRUE(test::waitUntil([&] { return device->counters().reports == 30; }));
  EXPECT_EQ(device->phase(), DevicePhase::kStreaming);
  const DeviceState state = lastState();
  EXPECT_NEAR(state.deviceFromStylus.offset.x, 14.5, 3);
  EXPECT_EQ(state.deviceFromStylus.offset.y, 20);
  ASSERT_TRUE(test::waitUntil([&] { return device->phase() == DevicePhase::kLost; }));
  EXPECT_EQ(device->error(), "The tracker does not see StylusToTracker. Turn the marker toward the tracker.");
  EXPECT_EQ(device->quality().quality, 0);
  ASSERT_TRUE(send("StylusToTracker", {{}, {1, 2, 3}}));
  ASSERT_TRUE(test::waitUntil([&] { return device->phase() == DevicePhase::kStreaming; }));
  EXPECT_EQ(device->quality().quality, 1);
  server.reset();
  ASSERT_TRUE(
      test::waitUntil([&] { return device->error().find("closed by the other program") != std::string::npos; }));
  EXPECT_EQ(device->phase(), DevicePhase::kLost);
  hand.reset();
  EXPECT_EQ(device->phase(), DevicePhase::kAbsent);
}

TEST_F(TrackerHandTest, NamesAToolThatTheTrackerSends) {
  begin("NeedleToTracker");
  ASSERT_TRUE(send("ProbeToTracker", {{}, {1, 2, 3}}));
  EXPECT_TRUE(test::waitUntil([&] {
    return hand->device()->error() == "The tracker sends no tool 'NeedleToTracker', but for example 'ProbeToTracker'.";
  }));
}

TEST_F(TrackerHandTest, TakesTheFirstToolWithoutAName) {
  begin("");
  ASSERT_TRUE(send("ProbeToTracker", {{}, {7, 2, 3}}));
  ASSERT_TRUE(test::waitUntil([&] { return hand->device()->phase() == DevicePhase::kStreaming; }));
  EXPECT_EQ(lastState().deviceFromStylus.offset, (Vec3{7, 2, 3}));
}

/// A marker that is tilted by `tilt` toward the direction `heading`, so that the tip stays in its place.
Transform pivoted(double tilt, double heading, Vec3 tip_marker, Vec3 pivot) {
  const Vec3 axis{-std::sin(heading), std::cos(heading), 0};
  const double c = std::cos(tilt), s = std::sin(tilt);
  const auto turn = [&](Vec3 v) { return c * v + s * cross(axis, v) + (1 - c) * dot(axis, v) * axis; };
  const Mat3 rotation{{turn({1, 0, 0}), turn({0, 1, 0}), turn({0, 0, 1})}};
  return {rotation, pivot - rotation * tip_marker};
}

TEST_F(TrackerHandTest, FindsTheTipByPivoting) {
  begin("StylusToTracker");
  EXPECT_FALSE(hand->calibrateTip());
  const Vec3 tip{12, -3, -140}, pivot{300, -50, 900};
  for (int i = 0; i < 60; ++i) {
    ASSERT_TRUE(send("StylusToTracker", pivoted(0.5, 0.4 * i, tip, pivot)));
    std::this_thread::sleep_for(std::chrono::milliseconds(3));
  }
  ASSERT_TRUE(test::waitUntil([&] { return hand->device()->counters().reports == 60; }));
  const auto found = hand->calibrateTip();
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_LT(norm(found->tip_body - tip), 0.01);
  const Transform markerFromStylus = hand->calibration().markerFromStylus;
  EXPECT_LT(norm(markerFromStylus.offset - tip), 0.01);
  EXPECT_LT(norm(markerFromStylus.linear.column[2] + normalized(tip)), 1e-4) << "-z toward the tip";
  EXPECT_NEAR(determinant(markerFromStylus.linear), 1, 1e-9);
  ASSERT_TRUE(send("StylusToTracker", pivoted(0.2, 1, tip, pivot)));
  ASSERT_TRUE(test::waitUntil([&] { return hand->device()->counters().reports == 61; }));
  EXPECT_LT(norm(lastState().deviceFromStylus.offset - pivot), 5);
}

TEST_F(TrackerHandTest, FindsTheDeskByHoldingTheToolStill) {
  begin("ProbeToTracker");
  // The tracker looks from the user's left: x of the outline is the tracker's z, down is the tracker's y.
  const Transform place{{{Vec3{0, 0, 1}, Vec3{1, 0, 0}, Vec3{0, 1, 0}}}, {50, 60, 1200}};
  for (int i = 0; i < 30; ++i) {
    ASSERT_TRUE(send("ProbeToTracker", place));
    std::this_thread::sleep_for(std::chrono::milliseconds(3));
  }
  ASSERT_TRUE(test::waitUntil([&] { return hand->device()->counters().reports == 30; }));
  const auto desk = hand->setDesk();
  ASSERT_TRUE(desk) << desk.error().message;
  const Transform deviceFromTracker = hand->calibration().deviceFromTracker;
  EXPECT_LT(norm(deviceFromTracker * place.offset), 1e-3);
  EXPECT_LT(norm(deviceFromTracker * (place.offset + Vec3{0, 0, 10}) - Vec3{10, 0, 0}), 1e-3) << "to the right";
  EXPECT_LT(norm(deviceFromTracker * (place.offset + Vec3{0, -10, 0}) - Vec3{0, 10, 0}), 1e-3) << "up";
}

}  // namespace
}  // namespace insonate
