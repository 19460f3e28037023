#include "CaseSamples.h"

#include <insonate/cases/StartPose.h>

#include <gmock/gmock.h>

namespace insonate {
namespace {

using testing::HasSubstr;

TEST(StartPose, OnTheSkinNearestToTheTarget) {
  PatientCase patient = test::cylinderNeck();
  patient.manifest.startPoses.clear();
  const auto pose = proposeStartPose(patient);
  ASSERT_TRUE(pose) << pose.error().message;
  EXPECT_NEAR(std::hypot(pose->position_mm.x, pose->position_mm.y), 50, 1) << "on the cylinder's surface";
  EXPECT_EQ(pose->position_mm.z, 0);
  const Vec3 target = patient.manifest.targets[0].position_mm;
  EXPECT_NEAR(norm(cross(pose->axial, target - pose->position_mm)), 0, 1e-9) << "looks at the target";
  // The nearest skin of a cylinder lies on the line from its axis through the target.
  const Vec3 inward = normalized({30, 22, 0});
  EXPECT_GT(dot(pose->axial, inward), std::cos(0.1)) << "square to the skin";
  EXPECT_NEAR(dot(pose->lateral, pose->axial), 0, 1e-9);
  EXPECT_NEAR(norm(pose->lateral), 1, 1e-9);
  EXPECT_GT(pose->lateral.x, 0.5)
      << "marker to the patient's left, so the patient's right is on the left of the screen";
}

TEST(StartPose, WithoutTargetOnTheFront) {
  PatientCase patient = test::cylinderNeck();
  patient.manifest = {};
  const auto pose = proposeStartPose(patient);
  ASSERT_TRUE(pose) << pose.error().message;
  EXPECT_NEAR(pose->position_mm.x, 0, 0.5);
  EXPECT_NEAR(pose->position_mm.y, -50.5, 0.5);
  EXPECT_EQ(pose->axial, (Vec3{0, 1, 0}));
  EXPECT_EQ(pose->lateral, (Vec3{1, 0, 0}));
}

TEST(StartPose, WithoutLabelsFromTheCt) {
  PatientCase patient = test::cylinderNeck();
  patient.manifest = {};
  patient.labels = LabelMap(patient.ct.geometry);
  // A blanket over the patient, thinner than a body.
  for (int k = 0; k < 61; ++k)
    for (int i = 0; i < 121; ++i) patient.ct.at(i, 4, k) = -50;
  const auto pose = proposeStartPose(patient);
  ASSERT_TRUE(pose) << pose.error().message;
  EXPECT_NEAR(pose->position_mm.y, -50, 1);
}

TEST(StartPose, FollowsThePatientNotTheGrid) {
  PatientCase patient = test::cylinderNeck();
  patient.manifest = {};
  // The same patient, stored with i and j reversed.
  VolumeGeometry& g = patient.ct.geometry;
  g.origin_mm = {60, 60, -30};
  g.direction.column[0] = {-1, 0, 0};
  g.direction.column[1] = {0, -1, 0};
  patient.labels.geometry = g;
  const auto pose = proposeStartPose(patient);
  ASSERT_TRUE(pose);
  EXPECT_LT(pose->position_mm.y, -45) << "anterior is -y in LPS whatever the storage order";
}

TEST(StartPose, StoredPoseComesFirst) {
  PatientCase patient = test::cylinderNeck();
  patient.manifest.startPoses[0].name = "stored";
  EXPECT_EQ(autoStartPose(patient)->name, "stored");
}

TEST(StartPose, NoSkinIsAnError) {
  PatientCase empty;
  empty.ct = CtVolume(test::grid({20, 20, 20}), -1000);
  empty.labels = LabelMap(empty.ct.geometry);
  EXPECT_THAT(proposeStartPose(empty).error().message, HasSubstr("No skin"));
  PatientCase full = empty;
  full.labels = LabelMap(full.ct.geometry, kMuscle);
  EXPECT_THAT(proposeStartPose(full).error().message, HasSubstr("No skin")) << "the volume's edge is no skin";
  full.manifest.targets = {{"t", kMuscle, {10, 10, 10}}};
  EXPECT_THAT(proposeStartPose(full).error().message, HasSubstr("\"t\""));
}

}  // namespace
}  // namespace insonate
