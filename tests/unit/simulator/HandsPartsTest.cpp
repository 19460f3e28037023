#include "LiveProbe.h"
#include "hands/FacePatches.h"
#include "hands/RestNear.h"
#include "support/Allocations.h"

#include <insonate/cases/HeartDirection.h>
#include <insonate/cases/Phantom.h>
#include <insonate/simulator/NeedlePlacement.h>

#include <numbers>

namespace insonate {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

Transform face(double in_mm) {
  return *patientFromProbe({0, in_mm, 0}, {0, 1, 0}, {1, 0, 0});
}

double forceOf(const LocalModel& model, const Transform& patientFromProbe) {
  double sum_N = 0;
  for (int i = 0; i < model.patchCount; ++i) {
    const SkinPatch& patch = model.patches[i];
    const double d = -dot(patientFromProbe * patch.onProbe_mm - patch.skin_mm, patch.outward);
    if (d > 0) sum_N += patch.stiffness_Npmm * d + patch.stiffening_Npmm2 * d * d;
  }
  return sum_N;
}

LiveDeformation pressed(double in_mm, double force_N) {
  LiveDeformation press;
  press.indentation_mm = in_mm, press.force_N = force_N;
  return press;
}

TEST(FacePatches, GiveTheSolvedForceWhereItWasSolvedAndItsSlopeRoundIt) {
  const auto patient = test::wideCase();
  const SkinSurface skin = *SkinSurface::make(patient->labels);
  const ProbeFace flat{.width_mm = 38};
  FacePatches patches;
  patches.learn(skin, flat, face(3.5), pressed(4, 1.2));
  patches.learn(skin, flat, face(4.5), pressed(5, 1.7));
  LocalModel model;
  patches.show(skin, flat, face(4.5), model);
  ASSERT_EQ(model.patchCount, 3);
  EXPECT_NEAR(forceOf(model, face(4.5)), 1.7, 1e-6);
  EXPECT_NEAR(forceOf(model, face(4.6)) - forceOf(model, face(4.4)), 0.2 * 0.5, 0.01) << "0.5 N/mm";
  EXPECT_LT(forceOf(model, face(-0.6)), 1e-9) << "off the skin";
  // Exaggerated by a model on its way, and off the skin, nothing is learned.
  LiveDeformation wild = pressed(5, 80);
  wild.settled = false;
  patches.learn(skin, flat, face(4.5), wild);
  patches.learn(skin, flat, face(-3), pressed(-2, 0));
  patches.show(skin, flat, face(4.5), model);
  EXPECT_NEAR(forceOf(model, face(4.5)), 1.7, 1e-6);
}

TEST(FacePatches, BesideTheBodyNothingIsFeltAndNothingAllocated) {
  const auto patient = test::wideCase();
  const SkinSurface skin = *SkinSurface::make(patient->labels);
  const ProbeFace curved{.width_mm = 60, .radius_mm = 60};
  const FacePatches patches;
  LocalModel model;
  const Transform away = *patientFromProbe({0, -60, 0}, {0, 1, 0}, {1, 0, 0});
  const long before = test::allocations();
  patches.show(skin, curved, away, model);
  EXPECT_EQ(test::allocations(), before);
  EXPECT_EQ(forceOf(model, away), 0);
  patches.show(skin, curved, face(1), model);
  EXPECT_NEAR(model.patches[0].onProbe_mm.z, std::sqrt(60 * 60 - 27 * 27) - 60, 1e-9) << "an arc falls back";
}

TEST(RestNear, ALinearDisplacementIsTakenOverAndFadesBesideThePlane) {
  PlaneDisplacement d{
      .left_mm = -20, .top_mm = -10, .step_mm = 0.5, .columns = 81, .rows = 101, .restFromDisplayed = {}, .lung = {}};
  for (int row = 0; row < d.rows; ++row)
    for (int column = 0; column < d.columns; ++column) {
      const float x = -20 + 0.5F * column, z = -10 + 0.5F * row;
      d.restFromDisplayed.push_back({0.02F * x, -0.1F * z - 1});
    }
  const Transform pose = *patientFromProbe({10, -40, 5}, {0.3, 1, 0}, {1, -0.3, 0});
  const Vec3 point = pose * Vec3{4, 0, 12};
  const Transform map = restNear(d, pose, point);
  for (const Vec3 by : {Vec3{0, 0, 0}, Vec3{1, 0, -2}, Vec3{-2, 1, 1}}) {
    const Vec3 seen = Vec3{4, 0, 12} + by, rest = inverted(pose) * (map * (pose * seen));
    EXPECT_NEAR(rest.x, 1.02 * seen.x, 1e-5);
    EXPECT_NEAR(rest.z, 0.9 * seen.z - 1, 1e-5);
    EXPECT_NEAR(rest.y, seen.y, 1e-5);
  }
  const Vec3 beside = pose * Vec3{4, 1.5 * kMovesBeside_mm, 12};
  EXPECT_NEAR((inverted(pose) * (restNear(d, pose, beside) * beside)).z, 12 - 0.5 * 2.2, 1e-5) << "half of it";
  EXPECT_EQ(restNear(d, pose, pose * Vec3{4, 2.5 * kMovesBeside_mm, 12}), Transform{});
  EXPECT_EQ(restNear({}, pose, point), Transform{});
  // The lattice ends 20 mm aside.
  const Vec3 aside = pose * Vec3{26, 0, 12};
  EXPECT_NEAR((inverted(pose) * (restNear(d, pose, aside) * aside)).z, 12 - 0.25 * 2.2, 1e-5) << "a quarter of it";
  const Vec3 farAside = pose * Vec3{29, 0, 12};
  EXPECT_LT(norm(restNear(d, pose, farAside) * farAside - farAside), 1e-9);
}

TEST(RestNear, AThinnedLatticeKeepsTheDisplacementOfItsPoints) {
  PlaneDisplacement d{
      .left_mm = -20, .top_mm = -5, .step_mm = 0.25, .columns = 161, .rows = 62, .restFromDisplayed = {}, .lung = {}};
  for (int i = 0; i < d.columns * d.rows; ++i) d.restFromDisplayed.push_back({static_cast<float>(i), 1});
  PlaneDisplacement thin;
  thinOut(d, thin);
  EXPECT_EQ(thin.step_mm, 1);
  EXPECT_EQ(thin.columns, 41);
  EXPECT_EQ(thin.rows, 16);
  EXPECT_EQ(shiftAt(thin, 3, 7), shiftAt(d, 3, 7));
  EXPECT_EQ(shiftAt(thin, 20, 10), shiftAt(d, 20, 10));
  thinOut({}, thin);
  EXPECT_TRUE(thin.empty());
}

struct Held {
  std::shared_ptr<const PatientCase> patient = test::wideCase();
  ProbePlacement probe = *ProbePlacement::make(patient->labels, face(-0.5));
};

TEST(NeedlePlacement, InPlaneItLiesBesideTheProbeAndFlat) {
  Held held;
  const NeedlePlacement needle = NeedlePlacement::makeBeside(held.probe, 19, NeedlePlane::InPlane, {});
  const Transform pose = needle.patientFromNeedle();
  EXPECT_NEAR(needle.state().entry_mm.x, -24, 0.1);
  EXPECT_NEAR(needle.state().entry_mm.z, 0, 0.1);
  EXPECT_NEAR(pose.linear.column[2].x, std::cos(NeedlePlacement::kInitialAngle_deg * kDegree), 0.02);
  EXPECT_NEAR(pose.linear.column[2].y, std::sin(NeedlePlacement::kInitialAngle_deg * kDegree), 0.02);
  EXPECT_NEAR(pose.linear.column[1].y, std::cos(NeedlePlacement::kInitialAngle_deg * kDegree), 0.02)
      << "the bevel, along -y, looks out of the skin";
  EXPECT_NEAR(norm(pose.offset - needle.state().entry_mm), 5, 1e-9);
  EXPECT_NEAR(determinant(pose.linear), 1, 1e-9);
  EXPECT_NEAR(needle.heading_deg(), 90, 1) << "to the patient's left";
  EXPECT_FALSE(needle.isInBody());
}

class NeedlePlacementOn : public testing::TestWithParam<const char*> {};

/// At each start pose, and at poses all round: slid, turned, tilted and rocked.
TEST_P(NeedlePlacementOn, InPlaneTheWholeShaftLiesInTheSlice) {
  const auto patient = makePhantom(GetParam(), 1);
  ASSERT_TRUE(patient) << patient.error().message;
  std::uint32_t state = 1;
  const auto between = [&](double low, double high) {
    state = state * 1664525U + 1013904223U;
    return low + (high - low) * (state >> 8) / double(1U << 24);
  };
  // In the hollow below the clavicle, a probe that is turned far has no skin beside its face.
  const int tries = GetParam() == std::string_view("axillary") ? 1 : 50;
  int poses = 0, outside = 0;
  for (const StartPose& start : patient->manifest.startPoses) {
    const auto there =
        ProbePlacement::make(patient->labels, *patientFromProbe(start.position_mm, start.axial, start.lateral));
    ASSERT_TRUE(there) << there.error().message;
    for (int i = 0; i < tries; ++i) {
      ProbePlacement probe = *there;
      if (i > 0) {
        probe.slide(between(-25, 25), between(-25, 25));
        probe.rotate(between(-90, 90)), probe.tilt(between(-20, 20)), probe.rock(between(-20, 20));
      }
      const NeedlePlacement needle = NeedlePlacement::makeBeside(probe, 19, NeedlePlane::InPlane, {});
      ++poses;
      if (i == 0) {
        EXPECT_LE(needle.offPlane_mm(probe.pose()), 0.1) << start.name;
      }
      if (needle.offPlane_mm(probe.pose()) <= 0.1) {
        const double angle_deg = needle.state().angle_deg;
        EXPECT_GE(angle_deg, NeedlePlacement::kMinAngle_deg - 1e-9);
        const Transform probeFromNeedle = inverted(probe.pose()) * needle.patientFromNeedle();
        EXPECT_LT(std::abs(probeFromNeedle.linear.column[2].y), 1e-9) << "its direction, too";
        NeedlePlacement steeper = needle;
        steeper.tilt(25);
        EXPECT_LE(steeper.offPlane_mm(probe.pose()), 0.1) << "and as it is aimed";
        steeper.slide(probe.pose(), -4, 0);
        // If the skin ends, the needle is put on the nearest skin, and keeps to no plane.
        if (steeper.state().planeNormal) {
          EXPECT_LE(steeper.offPlane_mm(probe.pose()), 0.1) << "and slid";
        }
      } else {
        ++outside;
      }
    }
  }
  EXPECT_LE(outside, poses / 20) << "of " << poses;
}

INSTANTIATE_TEST_SUITE_P(Regions, NeedlePlacementOn,
                         testing::Values("textbook", "axillary", "arm", "groin", "groin-overlap", "groin-obese"),
                         [](const auto& variant) {
                           std::string name = variant.param;
                           std::erase(name, '-');
                           return name;
                         });

TEST(NeedlePlacement, AcrossItComesFromTheSideOfThePlane) {
  Held held;
  const NeedlePlacement needle = NeedlePlacement::makeBeside(held.probe, 19, NeedlePlane::OutOfPlane, {});
  const Vec3 from = needle.state().entry_mm - held.probe.pose().offset;
  EXPECT_NEAR(std::abs(dot(from, held.probe.pose().linear.column[1])), 12, 0.1);
  EXPECT_LT(dot(needle.state().heading, from), -11.9) << "toward the probe";
  EXPECT_EQ(needle.state().angle_deg, NeedlePlacement::kInitialAngle_deg);
}

/// A wire follows the needle's direction: a needle that points away from the heart leads the wire there.
TEST_P(NeedlePlacementOn, ItPointsTowardTheHeart) {
  const auto patient = makePhantom(GetParam(), 1);
  ASSERT_TRUE(patient) << patient.error().message;
  int outOfPlane = 0, inPlane = 0;
  for (const StartPose& start : patient->manifest.startPoses) {
    const auto probe =
        ProbePlacement::make(patient->labels, *patientFromProbe(start.position_mm, start.axial, start.lateral));
    ASSERT_TRUE(probe) << probe.error().message;
    const Transform pose = probe->pose();
    const auto toward = veinTowardHeart(patient->manifest, pose * Vec3{0, 0, 15});
    ASSERT_TRUE(toward) << start.name;
    const auto cosineOf = [&](NeedlePlane plane) {
      const NeedlePlacement needle = NeedlePlacement::makeBeside(*probe, 19, plane, toward);
      if (plane == NeedlePlane::InPlane) {
        EXPECT_LE(needle.offPlane_mm(pose), 0.1) << start.name;
      }
      return dot(needle.state().heading, *toward);
    };
    const double across = std::abs(dot(*toward, pose.linear.column[1]));
    if (across > 0.6) {
      ++outOfPlane;
      EXPECT_GT(cosineOf(NeedlePlane::OutOfPlane), 0.5) << start.name;
    }
    const double along = std::abs(dot(*toward, pose.linear.column[0]));
    if (along > 0.6) {
      ++inPlane;
      EXPECT_GT(cosineOf(NeedlePlane::InPlane), 0.5) << start.name;
    }
  }
  EXPECT_GT(outOfPlane + inPlane, 1);
}

/// On curved skin, a needle at a constant angle to the skin would pass the image at another depth.
TEST_P(NeedlePlacementOn, OutOfPlaneItSlidesWithoutTurning) {
  const auto patient = makePhantom(GetParam(), 1);
  ASSERT_TRUE(patient) << patient.error().message;
  for (const StartPose& start : patient->manifest.startPoses) {
    const auto probe =
        ProbePlacement::make(patient->labels, *patientFromProbe(start.position_mm, start.axial, start.lateral));
    ASSERT_TRUE(probe) << probe.error().message;
    const Transform pose = probe->pose();
    NeedlePlacement needle = NeedlePlacement::makeBeside(*probe, 19, NeedlePlane::OutOfPlane, {});
    needle.tilt(45 - needle.state().angle_deg);
    const Vec3 axis = needle.patientFromNeedle().linear.column[2];
    for (const double lateral_mm : {3., -5.}) {
      ASSERT_TRUE(needle.slide(pose, lateral_mm, 0).done()) << start.name;
      EXPECT_GT(dot(needle.patientFromNeedle().linear.column[2], axis), 1 - 1e-9) << start.name;
    }
  }
}

TEST(NeedlePlacement, TurnsAboutItsEntryUntilTissueHoldsIt) {
  Held held;
  NeedlePlacement needle = NeedlePlacement::makeBeside(held.probe, 19, NeedlePlane::InPlane, {});
  const Vec3 entry = needle.state().entry_mm;
  needle.advance(13);  // 8 mm in
  EXPECT_TRUE(needle.tilt(5).done());
  EXPECT_TRUE(needle.turn(-10).done());
  EXPECT_NEAR(needle.heading_deg(), 80, 1);
  const Transform pose = needle.patientFromNeedle();
  EXPECT_NEAR(norm(pose.offset - pose.linear.column[2] * 8 - entry), 0, 1e-9);
  EXPECT_EQ(needle.slide(held.probe.pose(), 1, 0).stopped.substr(0, 24), "The needle is in the ski");
  needle.advance(4);
  EXPECT_FALSE(needle.tilt(1).done());
  EXPECT_FALSE(needle.turn(1).done());
  EXPECT_TRUE(needle.rotateBevel(190).done());
  EXPECT_NEAR(needle.state().bevel_deg, -170, 1e-9);
  EXPECT_NEAR(needle.patientFromNeedle().linear.column[2].y, pose.linear.column[2].y, 1e-9) << "the bevel turns alone";
}

TEST(NeedlePlacement, EndsWhereItEndsAndSaysSo) {
  Held held;
  NeedlePlacement needle = NeedlePlacement::makeBeside(held.probe, 19, NeedlePlane::InPlane, {});
  EXPECT_FALSE(needle.tilt(-80).done());
  EXPECT_EQ(needle.state().angle_deg, NeedlePlacement::kMinAngle_deg);
  EXPECT_FALSE(needle.tilt(200).done());
  EXPECT_NEAR(needle.state().angle_deg, 90, 1);
  EXPECT_FALSE(needle.advance(200).done());
  EXPECT_EQ(needle.state().advance_mm, NeedlePlacement::kLength_mm);
  EXPECT_FALSE(needle.advance(-200).done());
  EXPECT_FALSE(needle.advance(NAN).done());
  EXPECT_TRUE(needle.slide(held.probe.pose(), 10, 0).done());
  EXPECT_NEAR(needle.state().entry_mm.x, -14, 0.2);
  EXPECT_FALSE(needle.slide(held.probe.pose(), -200, 0).done()) << "the scan ends there";
  EXPECT_NEAR(needle.state().entry_mm.x, -14, 0.2);
}

}  // namespace
}  // namespace insonate
