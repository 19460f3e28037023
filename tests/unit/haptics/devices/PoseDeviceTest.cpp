#include <insonate/haptics/PoseDevice.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>

using namespace insonate;

namespace {

constexpr std::int64_t kMs = 1'000'000, kFrame_ns = 33'333'333, kBegin_ns = 1'000'000'000;

DeviceState at(std::int64_t time_ns, Vec3 place_mm, Vec3 velocity_mmps = {}) {
  DeviceState state;
  state.deviceFromStylus.offset = place_mm;
  state.velocity_mmps = velocity_mmps;
  state.time_ns = time_ns;
  return state;
}

class PoseDeviceTest : public testing::Test {
 protected:
  DeviceState poll(std::int64_t now_ns) {
    EXPECT_TRUE(device.pollAt(now_ns, state));
    return state;
  }

  PoseDevice device{"camera:1/probe", "Camera: probe", 30, {400, 300, 400}};
  DeviceState state;
};

TEST_F(PoseDeviceTest, IsAbsentUntilPostedAndSaysWhyItIsLost) {
  EXPECT_EQ(device.phase(), DevicePhase::kAbsent);
  EXPECT_FALSE(device.pollAt(kBegin_ns, state));
  device.setPhase(DevicePhase::kReady);
  EXPECT_FALSE(device.pollAt(kBegin_ns, state)) << "no state has arrived";
  device.post(at(kBegin_ns, {1, 2, 3}));
  EXPECT_EQ(device.phase(), DevicePhase::kStreaming);
  EXPECT_EQ(poll(kBegin_ns + kMs).deviceFromStylus.offset, (Vec3{1, 2, 3}));
  EXPECT_EQ(state.time_ns, kBegin_ns + kMs);
  device.setPhase(DevicePhase::kLost, "The camera was unplugged.");
  EXPECT_FALSE(device.pollAt(kBegin_ns + 2 * kMs, state));
  EXPECT_EQ(device.error(), "The camera was unplugged.");
  device.post(at(kBegin_ns + 900 * kMs, {50, 2, 3}));
  EXPECT_EQ(device.error(), "");
  EXPECT_EQ(poll(kBegin_ns + 901 * kMs).deviceFromStylus.offset.x, 50) << "without a transition from the old place";
  EXPECT_EQ(device.counters().reports, 2U);
  EXPECT_EQ(device.info().limits.forceAxes, 0);
}

TEST_F(PoseDeviceTest, ExtrapolatesAtMostFiftyMillisecondsAndThenStays) {
  device.post(at(kBegin_ns, {}, {100, 0, 0}));
  EXPECT_NEAR(poll(kBegin_ns + 20 * kMs).deviceFromStylus.offset.x, 2, 1e-9);
  EXPECT_EQ(state.velocity_mmps.x, 100);
  EXPECT_NEAR(poll(kBegin_ns + 50 * kMs).deviceFromStylus.offset.x, 5, 1e-9);
  EXPECT_NEAR(poll(kBegin_ns + 700 * kMs).deviceFromStylus.offset.x, 5, 1e-9);
  EXPECT_EQ(state.velocity_mmps.x, 0);
}

TEST_F(PoseDeviceTest, TurnsWithItsAngularVelocity) {
  DeviceState turning = at(kBegin_ns, {});
  turning.angularVelocity_radps = {0, 2, 0};
  device.post(turning);
  const Mat3 turned = poll(kBegin_ns + 40 * kMs).deviceFromStylus.linear;
  EXPECT_NEAR(norm(turned.column[2] - Vec3{std::sin(0.08), 0, std::cos(0.08)}), 0, 1e-9);
}

TEST_F(PoseDeviceTest, CorrectionsAreBlendedWithinAFrame) {
  device.post(at(kBegin_ns, {}));
  for (std::int64_t t_ns = 0; t_ns < kFrame_ns; t_ns += kMs) poll(kBegin_ns + t_ns);
  device.post(at(kBegin_ns + kFrame_ns, {3, 0, 0}));
  double before_mm = 0, most_mm = 0;
  for (std::int64_t t_ns = kFrame_ns; t_ns < 2 * kFrame_ns + kMs; t_ns += kMs) {
    const double x_mm = poll(kBegin_ns + t_ns).deviceFromStylus.offset.x;
    EXPECT_GE(x_mm, before_mm - 1e-9);
    most_mm = std::max(most_mm, x_mm - before_mm);
    before_mm = x_mm;
  }
  EXPECT_LT(most_mm, 0.15) << "no step";
  EXPECT_NEAR(before_mm, 3, 0.01) << "arrived after one frame";
}

TEST_F(PoseDeviceTest, MovesAlsoIfStatesComeFasterThanTheyAreTaken) {
  for (int n = 0; n < 10; ++n) {
    device.post(at(kBegin_ns + n * 20 * kMs, {double(n), 0, 0}));
    if (n % 4 == 0) poll(kBegin_ns + n * 20 * kMs);
  }
  EXPECT_EQ(poll(kBegin_ns + 200 * kMs).deviceFromStylus.offset.x, 9);
  // States at 500 Hz do not lag behind.
  for (int n = 1; n <= 100; ++n) {
    device.post(at(kBegin_ns + (200 + n * 2) * kMs, {9 + 0.1 * n, 0, 0}, {50, 0, 0}));
    poll(kBegin_ns + (200 + n * 2) * kMs);
    poll(kBegin_ns + (201 + n * 2) * kMs);
  }
  EXPECT_NEAR(state.deviceFromStylus.offset.x, 19, 0.1);
}

/// A hand that shakes with 10 mm at 1 Hz, measured at 30 Hz with a delay of 40 ms and an exact velocity.
TEST_F(PoseDeviceTest, FollowsAHandWithoutJerks) {
  constexpr double kTurn_radps = 6.283, kWidth_mm = 10;
  std::int64_t measured_ns = kBegin_ns;
  double last_mm = 0, mostStep_mm = 0, mostOff_mm = 0;
  for (std::int64_t now_ns = kBegin_ns + 40 * kMs; now_ns < kBegin_ns + 3000 * kMs; now_ns += kMs) {
    if (now_ns - 40 * kMs >= measured_ns) {
      const double t = double(measured_ns - kBegin_ns) * 1e-9;
      device.post(at(measured_ns, {kWidth_mm * std::sin(kTurn_radps * t), 0, 0},
                     {kWidth_mm * kTurn_radps * std::cos(kTurn_radps * t), 0, 0}));
      measured_ns += kFrame_ns;
    }
    const double x_mm = poll(now_ns).deviceFromStylus.offset.x;
    if (now_ns > kBegin_ns + 41 * kMs) mostStep_mm = std::max(mostStep_mm, std::abs(x_mm - last_mm));
    last_mm = x_mm;
    mostOff_mm =
        std::max(mostOff_mm, std::abs(x_mm - kWidth_mm * std::sin(kTurn_radps * double(now_ns - kBegin_ns) * 1e-9)));
  }
  EXPECT_LT(mostStep_mm, 0.15) << "the hand itself moves by 0.063 mm in a millisecond";
  EXPECT_LT(mostOff_mm, 2.5);
}

TEST_F(PoseDeviceTest, IgnoresStatesThatAreNotFinite) {
  device.post(at(kBegin_ns, {1, 1, 1}));
  device.post(at(kBegin_ns + kMs, {std::nan(""), 0, 0}));
  EXPECT_EQ(poll(kBegin_ns + 2 * kMs).deviceFromStylus.offset, (Vec3{1, 1, 1}));
}

TEST_F(PoseDeviceTest, QualityIsThatOfTheMeasuringThread) {
  EXPECT_EQ(device.quality().quality, 1);
  device.setQuality({42, 0.5, "Hold the body nearer to the camera."});
  EXPECT_EQ(device.quality().latency_ms, 42);
  EXPECT_EQ(device.quality().advice, "Hold the body nearer to the camera.");
}

TEST_F(PoseDeviceTest, TwoThreadsExchangeWholeStates) {
  std::atomic<bool> isDone = false;
  std::jthread measuring([&] {
    for (int n = 1; n < 20000; ++n) device.post(at(kBegin_ns + n, {double(n), double(n), double(n)}));
    isDone = true;
  });
  std::int64_t now_ns = kBegin_ns + 1000 * kMs;
  while (!isDone) {
    if (!device.pollAt(now_ns += 100 * kMs, state)) continue;
    const Vec3 p = state.deviceFromStylus.offset;
    ASSERT_NEAR(p.x, p.y, 1e-6);
    ASSERT_NEAR(p.x, p.z, 1e-6);
  }
}

}  // namespace
