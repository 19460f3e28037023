#include "NeedleRig.h"

#include <random>

namespace insonate::haptics {
namespace {

using Kind = NeedleEventKind;
constexpr Vec3 kDown{0, 0, 1};

TEST(NeedleWalls, SkinThenVeinThenItsBackWallOnceEach) {
  NeedleRig rig;
  rig.put({0, 0, -10}, kDown);
  rig.push({0, 0, 22}, kDown, 10);
  EXPECT_EQ(rig.count(Kind::Entered, kSkin), 1);
  EXPECT_EQ(rig.count(Kind::Entered, kVein), 1);
  EXPECT_EQ(rig.count(Kind::Left, kVein), 0);
  EXPECT_EQ(rig.needle.state().in, kVein);
  rig.push({0, 0, 32}, kDown, 10);
  EXPECT_EQ(rig.count(Kind::Left, kVein), 1);
  EXPECT_EQ(rig.needle.state().in, kMuscle);
  EXPECT_EQ(rig.events.size(), 3U);
  EXPECT_NEAR(rig.events[1].depth_mm, 15, 0.1);
  EXPECT_NEAR(rig.events[2].depth_mm, 25, 0.1);
  rig.push({0, 0, -5}, kDown, 10);
  EXPECT_EQ(rig.count(Kind::Withdrawn, kVein), 2);
  EXPECT_EQ(rig.count(Kind::Withdrawn, kSkin), 1);
  EXPECT_FALSE(rig.needle.state().inBody);
  EXPECT_EQ(rig.lost, 0);
}

TEST(NeedleWalls, AWallGivesWayBeforeItIsPunctured) {
  NeedleRig rig;
  rig.put({0, 0, -1}, kDown);
  rig.push({0, 0, 3}, kDown, 5);
  EXPECT_TRUE(rig.events.empty());
  EXPECT_TRUE(rig.needle.state().tenting);
  EXPECT_NEAR(rig.needle.state().tent_mm, 3, 0.05);
  EXPECT_EQ(rig.needle.state().tented, kSkin);
  // 0.1 * 3 + 0.08 * 9; where it would grow steeper than 0.6 N/mm, from 3.1 mm on, it does not.
  EXPECT_NEAR(rig.needle.state().axial_N, 0.1 * 3 + 0.08 * 9, 0.02);
  rig.push({0, 0, -1}, kDown, 5);
  EXPECT_FALSE(rig.needle.state().tenting);
  EXPECT_EQ(rig.needle.state().axial_N, 0);
  EXPECT_TRUE(rig.events.empty());
}

TEST(NeedleWalls, ATremblingHandGoesThroughOnce) {
  NeedleRig rig;
  rig.put({0, 0, -1}, kDown);
  std::mt19937 random(1);
  std::normal_distribution<double> tremor(0, 0.15);
  for (double z = -1; z < 23; z += 0.005) rig.put({tremor(random), tremor(random), z + tremor(random)}, kDown);
  EXPECT_EQ(rig.count(Kind::Entered, kSkin), 1);
  EXPECT_EQ(rig.count(Kind::Entered, kVein), 1);
  EXPECT_EQ(rig.events.size(), 2U);
}

/// At 1 m/s a tick is a millimeter; the vein here is 0.8 mm thin.
TEST(NeedleWalls, NothingIsTunnelledAtAMetreASecond) {
  for (const double speed_mmps : {1000.0, 3000.0, 10000.0}) {
    NeedleRig rig({.veinRadius_mm = 0.4});
    rig.put({0, 0, -10}, kDown);
    rig.push({0, 0, 40}, kDown, speed_mmps);
    EXPECT_EQ(rig.count(Kind::Entered, kSkin), 1) << speed_mmps;
    EXPECT_EQ(rig.count(Kind::Entered, kVein), 1) << speed_mmps;
    EXPECT_EQ(rig.count(Kind::Left, kVein), 1) << speed_mmps;
    EXPECT_EQ(rig.events.size(), 3U) << speed_mmps;
  }
}

TEST(NeedleWalls, TheSameWallsAtEverySpeed) {
  for (const double speed_mmps : {1.0, 10.0, 100.0, 1000.0}) {
    NeedleRig rig;
    rig.put({-4.6, 0, -3}, {0.2, 0, 1});
    rig.push({-4.6 + 0.2 * 35, 0, 32}, {0.2, 0, 1}, speed_mmps);
    EXPECT_EQ(rig.events.size(), 3U) << speed_mmps;
  }
}

/// Along the vein, deeper and flatter: a chord through its upper rim, and one that only brushes it.
TEST(NeedleWalls, GrazingIncidence) {
  const auto across = [](double z_mm) {
    NeedleRig rig;
    // In the body already, below the skin at the side, then straight across above the vein's middle.
    rig.put({-24, 0, -1}, kDown);
    rig.push({-24, 0, 7}, kDown, 20);
    const Vec3 target{10, 0, z_mm};
    const Vec3 from{-24, 0, 7};
    const Vec3 axis = normalized(target - from);
    rig.push(target, axis, 20);
    return rig;
  };
  const NeedleRig through = across(26);
  EXPECT_EQ(through.count(Kind::Entered, kVein), 1);
  const NeedleRig brushed = across(14.2);
  EXPECT_EQ(brushed.count(Kind::Entered, kVein), 0);
  EXPECT_EQ(brushed.count(Kind::Entered, kSkin), 1);
}

TEST(NeedleWalls, AFlatNeedleSlidesOnTheSkin) {
  NeedleRig rig;
  const Vec3 flat{1, 0, 0.1};
  rig.put({-20, 0, -0.5}, flat);
  rig.push({20, 0, 1.5}, flat, 50);
  EXPECT_TRUE(rig.events.empty());
  EXPECT_GT(rig.needle.state().tent_mm, 1);
}

TEST(NeedleWalls, ReentryAtAnotherAngleIsAnotherPuncture) {
  NeedleRig rig;
  rig.put({0, 0, -5}, kDown);
  rig.push({0, 0, 21}, kDown, 20);
  rig.push({0, 0, 6}, kDown, 20);
  EXPECT_EQ(rig.count(Kind::Withdrawn, kVein), 1);
  EXPECT_TRUE(rig.needle.state().inBody);
  const Vec3 other = normalized(Vec3{0.15, 0, 1});
  // Turned about its entry, near the skin, then in again.
  rig.push(Vec3{0, 0, 0} + other * 6.0, other, 20);
  rig.push(Vec3{0, 0, 0} + other * 22.0, other, 20);
  EXPECT_EQ(rig.count(Kind::Entered, kSkin), 1);
  EXPECT_EQ(rig.count(Kind::Entered, kVein), 2);
}

TEST(NeedleWalls, BoneStopsAndIsToldOnce) {
  NeedleRig rig({.veinDepth_mm = 200, .bone_mm = 30});
  rig.put({0, 0, -5}, kDown);
  rig.push({0, 0, 33}, kDown, 20);
  EXPECT_EQ(rig.count(Kind::Struck, kBone), 1);
  EXPECT_TRUE(rig.needle.state().onBone);
  EXPECT_NEAR(rig.needle.drawnBack_mm(), 3, 0.1);
  EXPECT_GT(rig.needle.state().axial_N, 3 * 0.6);
  rig.push({0, 0, 25}, kDown, 20);
  EXPECT_FALSE(rig.needle.state().onBone);
  EXPECT_EQ(rig.needle.drawnBack_mm(), 0);
}

TEST(NeedleWalls, AJumpIsNoPuncture) {
  NeedleRig rig;
  rig.put({0, 0, -10}, kDown);
  rig.put({0, 0, 30}, kDown);
  EXPECT_TRUE(rig.events.empty());
  EXPECT_FALSE(rig.needle.state().inBody);
}

TEST(NeedleWalls, ANeedleThatIsGoneIsWithdrawnFromAllThatItWasThrough) {
  for (const bool jumps : {false, true}) {
    NeedleRig rig;
    rig.put({0, 0, -10}, kDown);
    rig.push({0, 0, 21}, kDown, 20);
    ASSERT_EQ(rig.count(Kind::Entered, kVein), 1);
    ASSERT_TRUE(rig.needle.state().inBody);
    rig.events.clear();
    if (jumps)
      rig.put({0, 0, -20}, kDown);
    else
      rig.remove();
    EXPECT_FALSE(rig.needle.state().inBody);
    EXPECT_EQ(rig.count(Kind::Withdrawn, kVein), 1);
    ASSERT_EQ(rig.count(Kind::Withdrawn, kSkin), 1);
    EXPECT_EQ(rig.events.back().wall, kSkin) << "the skin comes last";
    EXPECT_EQ(rig.events.back().tip_mm.z, 21) << "where it was";
    EXPECT_EQ(rig.events.back().time_ns, rig.time_ns);
    rig.events.clear();
    rig.put({0, 0, -10}, kDown);
    EXPECT_TRUE(rig.events.empty()) << "told once";
  }
}

/// A thousand random lines: where the straight line from the entry meets the vein squarely enough and long enough, it
/// is punctured, exactly once; where it misses it, never.
TEST(NeedleWalls, RandomLinesAgreeWithGeometry) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int met = 0, missed = 0;
  NeedleRig rig;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 axis = normalized(Vec3{0.6 * uniform(random), 0.6 * uniform(random), 1});
    const Vec3 entry{12 * uniform(random), 0, 0};
    rig.events.clear();
    rig.remove();
    rig.at = entry - axis * 3.0;
    rig.put(rig.at, axis);
    rig.push(entry + axis * 40.0, axis, 50 + 900 * std::abs(uniform(random)));
    const double flat = std::hypot(axis.x, axis.z);
    const double nearest = std::abs((axis.x * (20 - entry.z) - axis.z * (0 - entry.x)) / flat);
    EXPECT_EQ(rig.count(Kind::Entered, kSkin), 1) << i;
    if (nearest < 4) {
      EXPECT_EQ(rig.count(Kind::Entered, kVein), 1) << i << ": " << nearest;
      EXPECT_EQ(rig.count(Kind::Left, kVein), 1) << i << ": " << nearest;
      ++met;
    } else if (nearest > 5.3) {
      EXPECT_EQ(rig.count(Kind::Entered, kVein), 0) << i << ": " << nearest;
      ++missed;
    }
  }
  EXPECT_GT(met, 150);
  EXPECT_GT(missed, 150);
}

}  // namespace
}  // namespace insonate::haptics
