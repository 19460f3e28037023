#include "needle/ShaftTissue.h"
#include "needle/Springs.h"

#include <insonate/haptics/LatestValue.h>
#include <insonate/haptics/LocalModel.h>

#include <gtest/gtest.h>

#include <thread>

namespace insonate::haptics {
namespace {

TEST(Springs, QuadraticUntilTooSteepThenStraight) {
  const Stiffening law{0.1, 0.05, 0.4};
  EXPECT_DOUBLE_EQ(law.force_N(-1), 0);
  EXPECT_DOUBLE_EQ(law.force_N(2), 0.1 * 2 + 0.05 * 4);
  // Slope 0.4 is reached at 3 mm; beyond, 0.4 N for each mm.
  EXPECT_DOUBLE_EQ(law.force_N(5), 0.75 + 0.4 * 2);
  EXPECT_DOUBLE_EQ((Stiffening{10, 0, 0.4}).force_N(2), 0.8);
}

TEST(Springs, TissueIsCutOnceAndStaysCut) {
  CutFront cut;
  cut.restart(0);
  EXPECT_DOUBLE_EQ(cut.force_N(1, 0.8, 0.5), 0.5);
  EXPECT_DOUBLE_EQ(cut.force_N(10, 0.8, 0.5), 0.8);
  EXPECT_DOUBLE_EQ(cut.force_N(7, 0.8, 0.5), 0);
  EXPECT_NEAR(cut.force_N(9, 0.8, 0.5), 0.5 * (9 - (10 - 1.6)), 1e-12);
}

TEST(Springs, StickingHoldsMoreThanSliding) {
  StickSlip friction;
  friction.restart(0);
  EXPECT_DOUBLE_EQ(friction.force_N(1, 20, 0.4, 0.7, 0.5), 0.5);
  EXPECT_TRUE(friction.sticks());
  EXPECT_DOUBLE_EQ(friction.force_N(1.5, 20, 0.4, 0.7, 0.5), 0.4);
  EXPECT_FALSE(friction.sticks());
  EXPECT_NEAR(friction.force_N(9, 20, 0.4, 0.7, 0.5), 0.4, 1e-12);
  // Turning back, it sticks where it is, and the force comes down along the same spring.
  EXPECT_NEAR(friction.force_N(8.5, -20, 0.4, 0.7, 0.5), 0.15, 1e-12);
  EXPECT_TRUE(friction.sticks());
  EXPECT_NEAR(friction.force_N(0, -20, 0.4, 0.7, 0.5), -0.4, 1e-12);
}

TEST(Springs, SlowSlidingSticksAndSlips) {
  StickSlip friction;
  friction.restart(0);
  double most = 0, least = 1;
  for (int i = 0; i < 20000; ++i) {
    const double f = friction.force_N(i * 0.0005, 0.5, 0.4, 0.7, 0.5);
    most = std::max(most, f);
    if (i > 4000) least = std::min(least, f);
  }
  EXPECT_NEAR(most, 0.7, 0.01);
  EXPECT_NEAR(least, 0.4, 0.01);
}

/// No path, however it goes, gets more out of cutting and friction than it put in.
TEST(Springs, NoPathGainsEnergy) {
  for (int seed = 0; seed < 20; ++seed) {
    CutFront cut;
    StickSlip friction;
    cut.restart(0), friction.restart(0);
    std::srand(static_cast<unsigned>(seed));
    double s = 0, energy = 0, worst = 0;
    for (int i = 0; i < 20000; ++i) {
      const double step = 0.002 * (std::rand() / (RAND_MAX + 1.0) - 0.5) + 0.002 * std::sin(i * 0.003);
      s += step;
      // With the force after the step: what a continuous hand would meet, but for half a step.
      energy += step * (cut.force_N(s, 0.8, 0.5) + friction.force_N(s, 1000 * step, 0.4, 0.7, 0.5));
      worst = std::min(worst, energy);
    }
    EXPECT_GE(worst, 0) << seed;
  }
}

TEST(ShaftTissue, AddsUpWhatTheShaftLiesIn) {
  NeedleTable table;
  table.tissues[kFat] = {.friction_Npmm = 0.01, .stiction_Npmm = 0.02, .viscosity_Nspmm2 = 0.001, .lateral_Npmm2 = 0.1};
  table.tissues[kMuscle] = {.friction_Npmm = 0.03, .stiction_Npmm = 0.04};
  ShaftTissue shaft;
  for (double s = 0; s <= 30; s += 0.2) shaft.reach(s, table, s < 10 ? kFat : kMuscle);
  EXPECT_NEAR(shaft.upTo(10, table).slides_N, 0.1, 1e-9);
  EXPECT_NEAR(shaft.upTo(25.25, table).slides_N, 0.1 + 15.25 * 0.03, 1e-9);
  EXPECT_NEAR(shaft.upTo(25.25, table).holds_N, 0.2 + 15.25 * 0.04, 1e-9);
  EXPECT_NEAR(shaft.upTo(25.25, table).viscous_Nspmm, 0.01, 1e-9);
  EXPECT_NEAR(shaft.upTo(25.25, table).lateral_Npmm, 1, 1e-9);
  // Pulled back to 12 mm and pushed into fat.
  for (double s = 12; s <= 20; s += 0.2) shaft.reach(s, table, kFat);
  EXPECT_NEAR(shaft.upTo(20, table).slides_N, 0.1 + 2 * 0.03 + 8 * 0.01, 1e-9);
}

TEST(SkinPatch, FollowsForceAndSlopeOfOneSolution) {
  SkinPatch patch;
  setPatchForce(patch, 2, 5, 0.6);
  const auto force = [&](double d) { return patch.stiffness_Npmm * d + patch.stiffening_Npmm2 * d * d; };
  EXPECT_NEAR(force(5), 2, 1e-12);
  EXPECT_NEAR((force(5.001) - force(4.999)) / 0.002, 0.6, 1e-9);
  setPatchForce(patch, 2, 5, 0.1);
  EXPECT_DOUBLE_EQ(patch.stiffness_Npmm, 0.4);
  setPatchForce(patch, 2, 5, 5);
  EXPECT_NEAR(patch.stiffness_Npmm, 0, 1e-12);
  EXPECT_NEAR(force(5), 2, 1e-12);
}

TEST(LatestValue, ShowsTheLatestAndNeverATornOne) {
  struct Pair {
    int a = 0, b = 0;
  };
  LatestValue<Pair> box;
  EXPECT_EQ(box.read().a, 0);
  std::thread writer([&] {
    for (int i = 1; i <= 200000; ++i) box.write({i, -i});
  });
  int last = 0;
  while (last < 200000) {
    const Pair& seen = box.read();
    ASSERT_EQ(seen.a, -seen.b);
    ASSERT_GE(seen.a, last);
    last = seen.a;
  }
  writer.join();
}

}  // namespace
}  // namespace insonate::haptics
