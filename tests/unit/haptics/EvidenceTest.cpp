#include <insonate/haptics/HapticMeasurements.h>
#include <insonate/haptics/SimulatedDevice.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <thread>

namespace insonate {
namespace {

struct Curve {
  explicit Curve(double speed_mmps = 5) : points(needleForceCurve(*loadNeedleTable("measured"), speed_mmps, 2, 42)) {}
  /// On the way in.
  double most(double from_mm, double to_mm) const {
    double max_N = 0;
    for (const auto& p : in())
      if (p.depth_mm >= from_mm && p.depth_mm < to_mm) max_N = std::max(max_N, p.force_N);
    return max_N;
  }
  double mean(double from_mm, double to_mm) const {
    double sum = 0;
    int count = 0;
    for (const auto& p : in())
      if (p.depth_mm >= from_mm && p.depth_mm < to_mm) sum += p.force_N, ++count;
    return sum / std::max(count, 1);
  }
  std::vector<ForceDepthPoint> in() const { return {points.begin(), points.begin() + long(points.size() / 2)}; }
  std::vector<ForceDepthPoint> points;
};

/// Magnitudes: skin 0.5 to 4 N, fat some tenths, muscle about 1 N and growing with the shaft in it, a vein's wall some
/// tenths more (van Gerwen et al. 2012; Kobayashi et al. 2013), bone as stiff as the device.
TEST(ForceDepth, LayersAreOfPublishedMagnitude) {
  const Curve curve;
  const double skin_N = curve.most(0, 6);
  EXPECT_GT(skin_N, 0.5);
  EXPECT_LT(skin_N, 4);
  const double fat_N = curve.mean(7, 10), muscle_N = curve.mean(14, 18);
  EXPECT_GT(fat_N, 0.1);
  EXPECT_LT(fat_N, 0.8);
  EXPECT_GT(muscle_N, 0.6);
  EXPECT_LT(muscle_N, 2);
  const double vein_N = curve.most(18, 22) - muscle_N;
  EXPECT_GT(vein_N, 0.2);
  EXPECT_LT(vein_N, 1.5);
  EXPECT_GT(curve.most(40, 42) - curve.most(38, 40), 1.5);
}

TEST(ForceDepth, ForceFallsWhereAWallIsPunctured) {
  const auto points = Curve().in();
  std::vector<double> falls;
  for (std::size_t i = 1; i < points.size(); ++i)
    if (points[i].force_N < points[i - 1].force_N - 0.3) falls.push_back(points[i].depth_mm);
  // Skin, front and back of the vein, each after it was pushed in by some millimeters.
  ASSERT_EQ(falls.size(), 3U);
  EXPECT_NEAR(falls[0], 4.5, 1);
  EXPECT_NEAR(falls[1], 18 + 2.8, 1);
  EXPECT_NEAR(falls[2], 28 + 2.8, 1);
}

TEST(ForceDepth, TheWayBackIsFrictionOnly) {
  const Curve curve;
  double least = 0;
  for (auto p = curve.points.begin() + long(curve.points.size() / 2); p != curve.points.end(); ++p)
    least = std::min(least, p->force_N);
  EXPECT_LT(least, -0.1);
  EXPECT_GT(least, -1.5);
  EXPECT_EQ(curve.points.back().force_N, 0);
  EXPECT_EQ(curve.points.back().in, kBackground);
}

/// A mass with damping b only, on a wall looked at once a millisecond: unstable just above Colgate's 2 b / T.
TEST(StableStiffness, AFreeDeviceReachesColgatesBoundAndLittleMore) {
  for (const double b : {0.1, 0.2, 0.5}) {
    DeviceLimits device;
    device.maxForce_N = 1000, device.rate_Hz = 1000, device.mass_kg = 0.2, device.damping_Nspm = b;
    const double found = maxStableStiffness_Npmm(device, {0, 0, 0}, false);
    const double bound = passiveStiffness_Npmm(device, 0, 1e9);
    EXPECT_GT(found, 0.92 * bound) << b;
    EXPECT_LT(found, 1.08 * bound) << b;
  }
}

TEST(StableStiffness, EveryHandIsStableBelowTheBound) {
  DeviceLimits device;
  device.maxForce_N = 1000, device.rate_Hz = 1000, device.mass_kg = 0.1, device.damping_Nspm = 0.2;
  const double bound = passiveStiffness_Npmm(device, 0, 1e9);
  for (const Grip& grip : {Grip{0.02, 0, 1}, Grip{0.1, 0.2, 2}, Grip{0.3, 1, 10}, Grip{0.5, 0.1, 1}})
    EXPECT_GE(maxStableStiffness_Npmm(device, grip, false), 0.92 * bound) << grip.mass_kg;
}

TEST(StableStiffness, TheAccountKeepsHandsStableBeyondThem) {
  for (const DeviceProfile& profile : deviceProfiles()) {
    const double plain = maxStableStiffness_Npmm(profile.limits, {}, false);
    const double kept = maxStableStiffness_Npmm(profile.limits, {}, true);
    EXPECT_GE(kept, 0.9 * plain) << profile.name;
    EXPECT_GE(kept, profile.limits.maxStiffness_Npmm) << profile.name;
  }
}

TEST(SimulatedDevice, FollowsItsPathAndIsPushed) {
  SimulatedDevice device("test", deviceProfiles()[1], {}, {});
  device.setTarget({0, {10, 0, 0}, {}});
  DeviceState state;
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  while (state.deviceFromStylus.offset.x < 9 && std::chrono::steady_clock::now() < end) {
    ASSERT_TRUE(device.pollState(state));
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_GE(state.deviceFromStylus.offset.x, 9);
  device.push({{-2, 0, 0}, {}});
  while (state.deviceFromStylus.offset.x > 7 && std::chrono::steady_clock::now() < end) {
    device.pollState(state);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_LE(state.deviceFromStylus.offset.x, 7);  // 2 N on a grip of 0.5 N/mm
  device.setConnected(false);
  EXPECT_FALSE(device.pollState(state));
  EXPECT_EQ(device.phase(), DevicePhase::kLost);
  EXPECT_EQ(device.error(), "Desktop (simulated) was unplugged.");
}

}  // namespace
}  // namespace insonate
