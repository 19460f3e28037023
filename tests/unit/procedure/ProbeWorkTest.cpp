#include "metrics/ProbeWork.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace insonate::metrics {
namespace {

/// A probe that is moved along x and turned about z, a sample a millisecond.
class ProbeWorkTest : public testing::Test {
 protected:
  void go(double seconds, double speed_mmps, double turn_degps = 0, bool counting = true, double force_N = 0) {
    for (int i = 0; i < static_cast<int>(std::lround(seconds * 1000)); ++i) {
      time_us_ += 1000, x_mm_ += speed_mmps * 1e-3, angle_deg_ += turn_degps * 1e-3;
      const double a = angle_deg_ * std::numbers::pi / 180;
      const Mat3 turned{{Vec3{std::cos(a), std::sin(a), 0}, Vec3{-std::sin(a), std::cos(a), 0}, Vec3{0, 0, 1}}};
      const Transform pose{turned, {x_mm_, 0, 0}};
      work_.follow(time_us_, pose, force_N, counting);
    }
  }

  ProbeWork work_;
  std::int64_t time_us_ = 0;
  double x_mm_ = 0, angle_deg_ = 0;
};

TEST_F(ProbeWorkTest, FastMovementsApart) {
  go(0.5, 0), go(0.3, 60), go(0.3, 0), go(0.3, -60), go(0.5, 0);
  EXPECT_EQ(work_.translations(), 2);
  EXPECT_EQ(work_.rotations(), 0);
}

TEST_F(ProbeWorkTest, AShortRestIsWithinOneMovement) {
  go(0.3, 60), go(0.15, 0), go(0.3, 60);
  EXPECT_EQ(work_.translations(), 1);
}

TEST_F(ProbeWorkTest, SlowIsNoMovement) {
  go(3, 49, 49);
  EXPECT_EQ(work_.translations(), 0);
  EXPECT_EQ(work_.rotations(), 0);
}

TEST_F(ProbeWorkTest, FastTurns) {
  go(0.5, 0, 51), go(0.3, 0), go(0.5, 0, -60), go(0.3, 0), go(0.5, 0, 90);
  EXPECT_EQ(work_.rotations(), 3);
  EXPECT_EQ(work_.translations(), 0);
}

/// Noise of a tracker, 0.02 mm at 1 kHz, is 20 mm/s from sample to sample; it is no movement and no way.
TEST_F(ProbeWorkTest, NoiseIsNothing) {
  for (int i = 0; i < 5000; ++i) go(0.001, i % 2 ? 20 : -20);
  EXPECT_EQ(work_.translations(), 0);
  EXPECT_EQ(work_.path_mm(), 0);
}

TEST_F(ProbeWorkTest, PathCountsBetweenSkinAndVein) {
  go(1, 20, 0, false);
  EXPECT_FALSE(work_.path_mm());
  go(1, 20), go(1, -10);
  const double path_mm = *work_.path_mm();
  EXPECT_NEAR(path_mm, 29, 1) << "steps of a millimetre, a turn and an end";
  go(1, 20, 0, false);
  EXPECT_EQ(*work_.path_mm(), path_mm);
}

/// Put down here and taken up there: the way between is not the probe's on the patient.
TEST_F(ProbeWorkTest, PutDownAndTakenUpElsewhere) {
  go(0.2, 0);
  for (int i = 0; i < 100; ++i) work_.follow(time_us_ += 1000, std::nullopt, 0, true);
  x_mm_ = 200;
  go(0.2, 0);
  EXPECT_EQ(work_.translations(), 0);
  EXPECT_EQ(work_.path_mm(), 0);
}

TEST_F(ProbeWorkTest, ForceWhileItTouches) {
  EXPECT_FALSE(work_.forceMean_N());
  go(1, 0, 0, true, 2), go(1, 0, 0, true, 0), go(1, 0, 0, true, 4);
  EXPECT_DOUBLE_EQ(*work_.forceMean_N(), 3);
  EXPECT_DOUBLE_EQ(*work_.forceMax_N(), 4);
}

TEST_F(ProbeWorkTest, NeverHeldIsMissing) {
  work_.follow(1000, std::nullopt, 0, true);
  EXPECT_FALSE(work_.path_mm() || work_.translations() || work_.rotations() || work_.forceMean_N());
}

}  // namespace
}  // namespace insonate::metrics
