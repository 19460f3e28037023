#include "support/LabelPhantom.h"

#include <insonate/simulator/ProbePlacement.h>
#include <insonate/simulator/ProbePose.h>
#include <insonate/tissue/Labels.h>

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace insonate {
namespace {

using testing::HasSubstr;

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kRadius_mm = 50;

LabelMap sphere(double spacing_mm = 1, double noise = 0) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> jitter(-noise, noise);
  return test::paint(test::gridOver({-70, -70, -70}, {70, 70, 70}, spacing_mm),
                     [&](Vec3 p) { return norm(p) + jitter(random) < kRadius_mm ? kSoftTissue : kBackground; })
      .labels;
}

/// A neck of a sort: along z through the whole volume, 1 x 1 x 2.5 mm voxels.
LabelMap cylinder() {
  return test::paint(test::gridOver({-70, -70, -60}, {70, 70, 60}, Vec3{1, 1, 2.5}),
                     [](Vec3 p) { return std::hypot(p.x, p.y) < kRadius_mm ? kSoftTissue : kBackground; })
      .labels;
}

/// On the front of sphere or cylinder, transverse.
Transform front(double z_mm = 0) {
  return *patientFromProbe({0, -kRadius_mm, z_mm}, {0, 1, 0}, {1, 0, 0});
}

ProbePlacement handOn(const LabelMap& labels, const Transform& pose = front()) {
  auto hand = ProbePlacement::make(labels, pose);
  EXPECT_TRUE(hand) << hand.error().message;
  return *hand;
}

double angle_deg(Vec3 a, Vec3 b) {
  return std::atan2(norm(cross(a, b)), dot(a, b)) / kDegree;
}

void expectSamePose(const Transform& a, const Transform& b, double distance_mm, double degrees) {
  EXPECT_LT(norm(a.offset - b.offset), distance_mm);
  for (int axis = 0; axis < 3; ++axis) EXPECT_LT(angle_deg(a.linear.column[axis], b.linear.column[axis]), degrees);
}

void expectRigid(const Transform& t) {
  ASSERT_TRUE(isFinite(t.offset));
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) ASSERT_NEAR(dot(t.linear.column[a], t.linear.column[b]), a == b, 1e-9);
}

TEST(ProbePlacement, TakesTheStartPoseOverExactly) {
  const Transform tilted = *patientFromProbe({3, -kRadius_mm - 4, 5}, {0.1, 1, -0.3}, {1, 0.2, 0});
  const ProbePlacement hand = handOn(sphere(), tilted);
  expectSamePose(hand.pose(), tilted, 1e-9, 1e-6);
  EXPECT_NEAR(hand.state().press_mm, -4, 0.7);
}

TEST(ProbePlacement, SlidesAroundASphereWhereGeometrySays) {
  const LabelMap labels = sphere();
  for (const auto& [lateral, elevation] : {std::pair{30.0, 0.0}, {-30.0, 0.0}, {0.0, 30.0}, {20.0, -25.0}}) {
    ProbePlacement hand = handOn(labels);
    hand.moveTo({0, -kRadius_mm, 0});
    const Mat3 square = hand.pose().linear;
    ASSERT_TRUE(hand.slide(lateral, elevation).done());
    const double length_mm = std::hypot(lateral, elevation), turn = length_mm / kRadius_mm;
    const Vec3 along = (square.column[0] * lateral + square.column[1] * elevation) / length_mm;
    const Vec3 outward = Vec3{0, -std::cos(turn), 0} + along * std::sin(turn);
    const Transform pose = hand.pose();
    EXPECT_LT(norm(pose.offset - outward * kRadius_mm), 0.6);
    EXPECT_LT(angle_deg(pose.linear.column[2], -outward), 1.0);
  }
}

TEST(ProbePlacement, SlidingAroundAndAlongACylinder) {
  ProbePlacement hand = handOn(cylinder());
  hand.moveTo({0, -kRadius_mm, 0});
  // A quarter of the way round: the marker, lateral, turns from +x into the direction of travel there.
  ASSERT_TRUE(hand.slide(kRadius_mm * std::numbers::pi / 2, 0).done());
  EXPECT_LT(norm(hand.pose().offset - Vec3{kRadius_mm, 0, 0}), 0.8);
  EXPECT_LT(angle_deg(hand.pose().linear.column[2], {-1, 0, 0}), 1.5);
  EXPECT_LT(angle_deg(hand.pose().linear.column[0], {0, 1, 0}), 1.5);
  const double elevation = hand.pose().linear.column[1].z;
  ASSERT_TRUE(hand.slide(0, 20).done());
  EXPECT_NEAR(hand.pose().offset.z, 20 * elevation, 0.5);
}

TEST(ProbePlacement, AlongAndBackReturns) {
  for (const LabelMap& labels : {sphere(), cylinder(), sphere(1, 2)}) {
    ProbePlacement hand = handOn(labels);
    hand.moveTo({5, -kRadius_mm, 3});
    hand.tilt(15);
    const Transform before = hand.pose();
    ASSERT_TRUE(hand.slide(17, 9).done());
    EXPECT_GT(norm(hand.pose().offset - before.offset), 15);
    ASSERT_TRUE(hand.slide(-17, -9).done());
    expectSamePose(hand.pose(), before, 0.5, 1);
  }
}

TEST(ProbePlacement, NoisySkinDoesNotThrowTheProbeAbout) {
  ProbePlacement hand = handOn(sphere(1, 2.5));
  hand.moveTo({0, -kRadius_mm, 0});
  for (int step = 0; step < 60; ++step) {
    const Vec3 before = hand.pose().linear.column[2];
    ASSERT_TRUE(hand.slide(0.5, 0.3).done());
    const Transform pose = hand.pose();
    EXPECT_LT(angle_deg(pose.linear.column[2], before), 3);
    EXPECT_LT(angle_deg(pose.linear.column[2], -pose.offset), 6);
    EXPECT_NEAR(norm(pose.offset), kRadius_mm, 1.5);
  }
}

TEST(ProbePlacement, AnEarIsClimbedOrSaysStopButIsNeverJumpedOff) {
  // A sheet 4 mm thick that stands 20 mm out of the skin, and a chin with a sharp edge.
  const LabelMap labels = test::paint(test::gridOver({-60, -60, -40}, {60, 40, 40}, 1.0), [](Vec3 p) {
                            const bool head = p.y > 0;
                            const bool ear = std::abs(p.x - 15) < 2 && p.y > -20 && std::abs(p.z) < 15;
                            const bool chin = p.x < -20 && p.x > -45 && p.y > -15;
                            return head || ear || chin ? kSoftTissue : kBackground;
                          }).labels;
  for (const double way : {1.0, -1.0}) {
    ProbePlacement hand = handOn(labels, *patientFromProbe({0, 0, 0}, {0, 1, 0}, {1, 0, 0}));
    for (int step = 0; step < 90; ++step) {
      const Vec3 before = hand.pose().offset;
      const MoveResult move = hand.slide(way, 0);
      expectRigid(hand.pose());
      EXPECT_LT(norm(hand.pose().offset - before), 9);
      EXPECT_GT(hand.pose().offset.y, -23);
      EXPECT_LT(hand.pose().offset.y, 3);
      if (!move.done()) break;
    }
  }
}

TEST(ProbePlacement, TurnsAboutItsOwnAxes) {
  ProbePlacement hand = handOn(sphere());
  hand.moveTo({0, -kRadius_mm, 0});
  const Mat3 square = hand.pose().linear;
  ASSERT_TRUE(hand.rotate(90).done());
  EXPECT_LT(angle_deg(hand.pose().linear.column[0], square.column[1]), 1e-6);
  EXPECT_LT(angle_deg(hand.pose().linear.column[2], square.column[2]), 1e-6);
  ASSERT_TRUE(hand.rotate(-90).done());

  ASSERT_TRUE(hand.tilt(30).done());
  EXPECT_LT(angle_deg(hand.pose().linear.column[0], square.column[0]), 1e-6) << "fans about lateral";
  EXPECT_NEAR(angle_deg(hand.pose().linear.column[2], square.column[2]), 30, 1e-6);
  ASSERT_TRUE(hand.rock(20).done());
  EXPECT_GT(dot(hand.pose().linear.column[2], square.column[0]), 0) << "toward the marker";

  // About the probe's own axis, however it is held.
  const Vec3 axis = hand.pose().linear.column[2];
  const Vec3 lateral = hand.pose().linear.column[0];
  ASSERT_TRUE(hand.rotate(35).done());
  EXPECT_LT(angle_deg(hand.pose().linear.column[2], axis), 1e-6);
  EXPECT_NEAR(angle_deg(hand.pose().linear.column[0], lateral), 35, 1e-6);
  expectRigid(hand.pose());
}

TEST(ProbePlacement, StopsAtItsLimitsAndSaysWhy) {
  ProbePlacement hand = handOn(sphere());
  hand.moveTo({0, -kRadius_mm, 0});
  EXPECT_THAT(std::string(hand.tilt(75).stopped), HasSubstr("60 degrees"));
  EXPECT_EQ(hand.state().tilt_deg, 60);
  EXPECT_FALSE(hand.rock(-200).done());
  EXPECT_EQ(hand.state().rock_deg, -60);
  EXPECT_FALSE(hand.rotate(45).done());
  EXPECT_LE(std::abs(hand.state().tilt_deg), 60 + 1e-6);
  EXPECT_THAT(std::string(hand.press(25).stopped), HasSubstr("20 mm"));
  EXPECT_EQ(hand.state().press_mm, 20);
  EXPECT_THAT(std::string(hand.press(-21).stopped), HasSubstr("Lift"));
  EXPECT_EQ(hand.state().press_mm, 0);
}

TEST(ProbePlacement, PressesAlongItsAxisAndLifts) {
  ProbePlacement hand = handOn(sphere());
  hand.moveTo({0, -kRadius_mm, 0});
  const Transform paused = hand.pose();
  ASSERT_TRUE(hand.press(8).done());
  EXPECT_LT(norm(hand.pose().offset - (paused.offset + paused.linear.column[2] * 8)), 1e-9);
  hand.lift();
  EXPECT_LT(norm(hand.pose().offset - (paused.offset - paused.linear.column[2] * ProbePlacement::kLift_mm)), 1e-9);
  ASSERT_TRUE(hand.slide(10, 0).done()) << "above the skin";
  EXPECT_NEAR(norm(hand.pose().offset), kRadius_mm + ProbePlacement::kLift_mm, 1);
  ASSERT_TRUE(hand.press(3).done());
  EXPECT_NEAR(norm(hand.pose().offset), kRadius_mm - 3, 1);
}

TEST(ProbePlacement, StopsWhereTheScanEndsAndComesBack) {
  ProbePlacement hand = handOn(cylinder());
  hand.moveTo({0, -kRadius_mm, 0});
  const double toEnd = hand.pose().linear.column[1].z;
  EXPECT_THAT(std::string(hand.slide(0, 300 * toEnd).stopped), HasSubstr("scan ends"));
  EXPECT_GT(hand.pose().offset.z, 55);
  EXPECT_LE(hand.pose().offset.z, 60);
  EXPECT_LT(angle_deg(hand.pose().linear.column[2], {0, 1, 0}), 1) << "the cut is no skin";
  ASSERT_TRUE(hand.slide(0, -30 * toEnd).done());
  EXPECT_NEAR(hand.pose().offset.z, 28, 2);
}

TEST(ProbePlacement, MovesToTheNearestSkin) {
  ProbePlacement hand = handOn(sphere());
  for (const Vec3 place : {Vec3{30, 10, -5}, Vec3{0, 66, 3}, Vec3{-20, -20, 40}, Vec3{300, 0, 0}}) {
    ASSERT_TRUE(hand.moveTo(place).done());
    // Half a tenth of a millimeter of unevenness moves the nearest skin of a deep place by 2 degrees.
    EXPECT_NEAR(norm(hand.pose().offset), kRadius_mm, 0.6);
    EXPECT_LT(angle_deg(hand.pose().offset, place), 2.5);
    EXPECT_LT(angle_deg(hand.pose().linear.column[2], -hand.pose().offset), 1.0);
    expectRigid(hand.pose());
  }
}

TEST(ProbePlacement, ARotationDoesNotDependOnThePath) {
  for (const double rotation_deg : {0.0, 90.0, -40.0}) {
    ProbePlacement hand = handOn(sphere());
    ASSERT_TRUE(hand.rotate(rotation_deg).done());
    EXPECT_NEAR(rotationOf_deg(hand.state()), rotation_deg, 0.5);
    ASSERT_TRUE(hand.press(6).done());
    // Around to the back, to the head, to the left and to the front again.
    for (const Vec3 place : {Vec3{-50, 0, 0}, Vec3{0, 50, 5}, Vec3{0, 5, 50}, Vec3{50, 0, -3}, Vec3{0, -50, 0}})
      ASSERT_TRUE(hand.placeAt(place, rotation_deg).done());
    EXPECT_NEAR(rotationOf_deg(hand.state()), rotation_deg, 0.5);
    EXPECT_EQ(hand.state().press_mm, 0);
    EXPECT_LT(angle_deg(hand.pose().linear.column[0],
                        {std::cos(rotation_deg * kDegree), 0, -std::sin(rotation_deg * kDegree)}),
              2);
  }
}

TEST(ProbePlacement, AMoveAroundTheNeckKeepsTheRotation) {
  ProbePlacement hand = handOn(cylinder());
  ASSERT_TRUE(hand.rotate(30).done());
  for (const Vec3 place : {Vec3{-50, 0, 20}, Vec3{0, 50, -20}, Vec3{50, 0, 20}, Vec3{0, -50, 0}}) {
    ASSERT_TRUE(hand.moveTo(place).done());
    EXPECT_NEAR(rotationOf_deg(hand.state()), 30, 0.5);
  }
}

TEST(ProbePlacement, PocketsOfBackgroundAreNotSkin) {
  const LabelMap labels = test::paint(test::gridOver({-70, -70, -70}, {70, 70, 70}, 1.0), [](Vec3 p) {
                            return norm(p) < kRadius_mm && norm(p) > 20 ? kSoftTissue : kBackground;
                          }).labels;
  ProbePlacement hand = handOn(labels);
  hand.moveTo({0, -22, 0});
  EXPECT_NEAR(norm(hand.pose().offset), kRadius_mm, 0.8);
}

TEST(ProbePlacement, TakesOverWhatIsNearestToAPoseBeyondItsLimits) {
  ProbePlacement hand = handOn(sphere());
  const MoveResult away = hand.setPose(*patientFromProbe({0, -65, 0}, {0, -1, 0}, {1, 0, 0}));
  EXPECT_FALSE(away.done());
  EXPECT_NEAR(norm(hand.state().skin_mm), kRadius_mm, 1);
  expectRigid(hand.pose());
  EXPECT_FALSE(hand.setPose(*patientFromProbe({0, -10, 0}, {0, 1, 0}, {1, 0, 0})).done());
  EXPECT_EQ(hand.state().press_mm, ProbePlacement::kMaxPress_mm);

  const ProbePlacementState before = hand.state();
  Transform sick = front();
  sick.offset.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(hand.setPose(sick).done());
  sick = front();
  sick.linear.column[0] = sick.linear.column[0] * 2;
  EXPECT_FALSE(hand.setPose(sick).done());
  EXPECT_FALSE(hand.slide(std::numeric_limits<double>::quiet_NaN(), 0).done());
  EXPECT_FALSE(hand.tilt(std::numeric_limits<double>::infinity()).done());
  EXPECT_FALSE(hand.moveTo({0, std::numeric_limits<double>::infinity(), 0}).done());
  EXPECT_EQ(hand.state(), before);
}

TEST(ProbePlacement, StateIsSavedComparedAndRestored) {
  ProbePlacement hand = handOn(sphere());
  const ProbePlacementState saved = hand.state();
  const Transform pose = hand.pose();
  hand.slide(12, 3), hand.tilt(5), hand.rotate(40), hand.press(2);
  EXPECT_NE(hand.state(), saved);
  hand.restore(saved);
  EXPECT_EQ(hand.state(), saved);
  EXPECT_EQ(hand.pose(), pose);
  ProbePlacementState sick = saved;
  sick.inward = {};
  hand.restore(sick);
  EXPECT_EQ(hand.state(), saved);
}

TEST(ProbePlacement, TenThousandRandomMovesStayOnTheSkin) {
  ProbePlacement hand = handOn(sphere(1, 1));
  std::mt19937 random(11);
  std::uniform_real_distribution<double> some(-1, 1);
  for (int i = 0; i < 10'000; ++i) {
    switch (random() % 7) {
      case 0:
      case 1:
        hand.slide(15 * some(random), 15 * some(random));
        break;
      case 2:
        hand.rotate(180 * some(random));
        break;
      case 3:
        hand.tilt(40 * some(random));
        break;
      case 4:
        hand.rock(40 * some(random));
        break;
      case 5:
        random() % 5 ? void(hand.press(8 * some(random))) : hand.lift();
        break;
      default:
        hand.moveTo(Vec3{some(random), some(random), some(random)} * 80);
        break;
    }
    expectRigid(hand.pose());
    ASSERT_NEAR(norm(hand.state().skin_mm), kRadius_mm, 1.5);
    ASSERT_LT(angle_deg(hand.state().inward, -hand.state().skin_mm), 6);
    ASSERT_LE(std::abs(hand.state().tilt_deg), 60 + 1e-6);
    ASSERT_LE(std::abs(hand.state().rock_deg), 60 + 1e-6);
    ASSERT_LE(hand.state().press_mm, ProbePlacement::kMaxPress_mm);
  }
}

TEST(ProbePlacement, RefusesAMapWithoutSkin) {
  const auto refusal = [](const LabelMap& labels, const Transform& pose) {
    const auto hand = ProbePlacement::make(labels, pose);
    return hand ? std::string() : hand.error().message;
  };
  const VolumeGeometry grid = test::gridOver({-10, -10, -10}, {10, 10, 10}, 1.0);
  EXPECT_THAT(refusal(LabelMap(grid), front()), HasSubstr("no skin"));
  EXPECT_THAT(refusal(LabelMap(grid, kMuscle), front()), HasSubstr("no skin"));
  LabelMap torn(grid, kMuscle);
  torn.voxels.resize(7);
  EXPECT_THAT(refusal(torn, front()), HasSubstr("voxels"));
  Transform skewed = front();
  skewed.linear.column[1] = {1, 1, 1};
  EXPECT_THAT(refusal(sphere(2), skewed), HasSubstr("rotation"));
}

}  // namespace
}  // namespace insonate
