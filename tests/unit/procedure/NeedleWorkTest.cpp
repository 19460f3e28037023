#include "metrics/NeedleWork.h"

#include <gtest/gtest.h>

#include <cmath>

namespace insonate::metrics {
namespace {

/// Down and up along z from a hole at the origin, a quarter of a millimeter at once.
void go(NeedleWork& work, double from_mm, double to_mm, bool aspirating = false) {
  const int steps = static_cast<int>(std::abs(to_mm - from_mm) * 4);
  for (int i = 1; i <= steps; ++i) {
    const double depth_mm = from_mm + (to_mm - from_mm) * i / steps;
    work.follow({0, 0, depth_mm}, depth_mm, aspirating);
  }
}

TEST(NeedleWork, StraightToTheVein) {
  NeedleWork work;
  work.beginPass({});
  go(work, 0, 10);
  go(work, 10, 30, true);
  EXPECT_FALSE(work.inefficiency_percent()) << "not reached yet";
  work.endAtVein({0, 0, 30});
  go(work, 30, 35);  // what comes after does not count
  EXPECT_DOUBLE_EQ(work.path_mm(), 30);
  EXPECT_DOUBLE_EQ(*work.inefficiency_percent(), 0);
  EXPECT_NEAR(*work.deviation_mm(), 0, 1e-9);
  EXPECT_NEAR(*work.aspirating_percent(), 200.0 / 3, 1e-9);
  EXPECT_EQ(work.redirections(), 0);
}

/// 20 down, 10 up, 20 down: 50 mm for 30.
TEST(NeedleWork, BackAndOnAgain) {
  NeedleWork work;
  work.beginPass({});
  go(work, 0, 20, true), go(work, 20, 10), go(work, 10, 30);
  work.endAtVein({0, 0, 30});
  EXPECT_DOUBLE_EQ(work.path_mm(), 50);
  EXPECT_NEAR(*work.inefficiency_percent(), 200.0 / 3, 1e-9);
  EXPECT_EQ(work.redirections(), 1);
  EXPECT_NEAR(*work.aspirating_percent(), 50, 1e-9) << "20 of 40 mm forward";
}

TEST(NeedleWork, RedirectionsAreThreeMillimetresBackAndOn) {
  NeedleWork work;
  work.beginPass({});
  go(work, 0, 20), go(work, 20, 17.5), go(work, 17.5, 20);
  EXPECT_EQ(work.redirections(), 0) << "2.5 mm back";
  go(work, 20, 17), go(work, 17, 19.5), go(work, 19.5, 17);
  EXPECT_EQ(work.redirections(), 0) << "not on yet";
  go(work, 17, 20);
  EXPECT_EQ(work.redirections(), 1);
  work.beginPass({});
  go(work, 0, 3);
  EXPECT_EQ(work.redirections(), 1) << "a new pass is not a redirection";
}

/// Points of the way: (3, 0, 10) and (0, 0, 20); their squared distances from the line to (0, 0, 20) are 9 and 0.
TEST(NeedleWork, DeviationFromTheStraightLine) {
  NeedleWork work;
  work.beginPass({});
  work.follow({3, 0, 10}, 10, false);
  work.follow({0, 0, 20}, 20, false);
  work.endAtVein({0, 0, 20});
  EXPECT_NEAR(*work.deviation_mm(), std::sqrt(4.5), 1e-9);
  EXPECT_NEAR(work.path_mm(), 2 * std::sqrt(109), 1e-9);
}

TEST(NeedleWork, TremblingIsNoWay) {
  NeedleWork work;
  work.beginPass({});
  for (int i = 0; i < 10'000; ++i) {
    const double at_mm = 0.24 * std::sin(0.06 * i);
    work.follow({at_mm, 0, at_mm}, at_mm, true);
  }
  EXPECT_EQ(work.path_mm(), 0);
  EXPECT_FALSE(work.aspirating_percent()) << "it never went forward";
}

TEST(NeedleWork, PassesAddUp) {
  NeedleWork work;
  work.beginPass({});
  go(work, 0, 12), go(work, 12, 0);
  work.endPass({});
  work.beginPass({5, 0, 0});
  work.follow({5, 0, 20}, 20, false);
  work.endAtVein({5, 0, 20});
  EXPECT_DOUBLE_EQ(work.path_mm(), 44) << "the way outside does not count";
  EXPECT_NEAR(*work.inefficiency_percent(), 120, 1e-9);
}

}  // namespace
}  // namespace insonate::metrics
