#include "metrics/Punctures.h"

#include <gtest/gtest.h>

namespace insonate::metrics {
namespace {

/// A vein whose front wall lies 20 mm below the skin's hole, its back wall at 32 (figures 25 to 27 of the thesis).
class PuncturesTest : public testing::Test {
 protected:
  void SetUp() override { vein.beginPass(); }
  Punctures vein;
};

TEST_F(PuncturesTest, FrontWallThenOutByTheSameHole) {
  EXPECT_TRUE(vein.enter(20));
  vein.follow(25);
  EXPECT_TRUE(vein.inside());
  vein.follow(20.1);
  vein.withdraw(false);
  EXPECT_FALSE(vein.inside());
  EXPECT_FALSE(vein.beyond());
  EXPECT_EQ(vein.count(), 1);
  EXPECT_EQ(vein.through(), 0);
}

TEST_F(PuncturesTest, BackWall) {
  vein.enter(20);
  vein.leave(32);
  EXPECT_TRUE(vein.beyond());
  vein.withdraw(true);
  EXPECT_TRUE(vein.inside());
  EXPECT_FALSE(vein.beyond());
  vein.withdraw(false);
  EXPECT_EQ(vein.count(), 1);
  EXPECT_EQ(vein.through(), 1);
}

TEST_F(PuncturesTest, TremblingInTheFrontHoleIsOnePuncture) {
  for (int i = 0; i < 10; ++i) {
    EXPECT_EQ(vein.enter(20), i == 0);
    vein.withdraw(false);
    vein.follow(19.1);
  }
  EXPECT_EQ(vein.count(), 1);
  vein.follow(18.9);
  EXPECT_TRUE(vein.enter(20)) << "clear of the hole: another puncture";
  EXPECT_EQ(vein.count(), 2);
}

TEST_F(PuncturesTest, TremblingInTheBackHoleIsOneDoublePuncture) {
  vein.enter(20);
  for (int i = 0; i < 10; ++i) {
    vein.leave(32);
    vein.withdraw(true);
    vein.follow(31.1);
  }
  EXPECT_EQ(vein.through(), 1);
  vein.follow(30.9);
  vein.leave(32);
  EXPECT_EQ(vein.through(), 2);
}

/// Both walls at one depth: d1 alone would take it for the way out.
TEST_F(PuncturesTest, AVeinPressedFlatIsPuncturedThrough) {
  vein.enter(20);
  vein.leave(20);
  EXPECT_EQ(vein.through(), 1);
}

/// The vein is met at another depth: compared with the last pass's d1, leaving at 14 mm would be a way out.
TEST_F(PuncturesTest, EachPassHasItsOwnD1) {
  vein.enter(20);
  vein.withdraw(false);
  vein.beginPass();
  EXPECT_TRUE(vein.enter(8));
  vein.leave(14);
  EXPECT_EQ(vein.count(), 2);
  EXPECT_EQ(vein.through(), 1);
}

TEST_F(PuncturesTest, ComingOutBesideTheHoleIsNoDoublePuncture) {
  vein.enter(20);
  vein.leave(18.5);
  EXPECT_EQ(vein.through(), 0);
  EXPECT_FALSE(vein.inside());
}

TEST_F(PuncturesTest, ACrossingThatWasNotSeenIsNotMadeUp) {
  vein.leave(32);
  vein.withdraw(true);
  EXPECT_FALSE(vein.inside());
  EXPECT_EQ(vein.count() + vein.through(), 0);
  vein.enter(20);
  EXPECT_FALSE(vein.enter(21)) << "it is inside already";
  EXPECT_EQ(vein.count(), 1);
}

}  // namespace
}  // namespace insonate::metrics
