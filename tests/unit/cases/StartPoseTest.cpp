#include "CaseSamples.h"
#include "support/TestData.h"

#include <insonate/cases/Import.h>
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
  EXPECT_NEAR(pose->position_mm.x, -25, 1) << "right of the midline";
  EXPECT_NEAR(std::hypot(pose->position_mm.x, pose->position_mm.y), 50.5, 1);
  EXPECT_GT(dot(pose->axial, normalized({25, 43.5, 0})), std::cos(0.06)) << "square to the skin";
  EXPECT_GT(pose->lateral.x, 0.8);
  EXPECT_THAT(pose->name, HasSubstr("middle"));
}

/// Head, neck and shoulders as round and oval pieces, with arms raised beside the head; z from -150 to 150 mm.
PatientCase standingMan() {
  PatientCase patient;
  patient.ct = CtVolume(test::grid({140, 100, 100}, {3, 3, 3}, {-210, -150, -150}), -1000);
  patient.labels = LabelMap(patient.ct.geometry);
  for (int k = 0; k < 100; ++k)
    for (int j = 0; j < 100; ++j)
      for (int i = 0; i < 140; ++i) {
        const double x = -210 + 3 * i, y = -150 + 3 * j, z = -150 + 3 * k;
        const double head = std::hypot(x / 75, y / 95, (z - 60) / 80.0), neck = std::hypot(x, y) / 55;
        const bool shoulders = std::hypot(x / 190, y / 100) < 1 && z < -70;
        const bool arms = std::hypot(std::abs(x) - 150, y) < 40 && z > -75;
        if (head < 1 || (neck < 1 && z < 30) || shoulders || arms) {
          patient.labels.at(i, j, k) = kMuscle;
          patient.ct.at(i, j, k) = 50;
        }
      }
  return patient;
}

TEST(StartPose, WithoutTargetOnTheNeckAndNotOnTheNose) {
  PatientCase patient = standingMan();
  for (const bool labeled : {true, false}) {
    if (!labeled) patient.labels = LabelMap(patient.ct.geometry);
    const auto pose = proposeStartPose(patient);
    ASSERT_TRUE(pose) << pose.error().message;
    EXPECT_GT(pose->position_mm.z, -72) << pose->name;
    EXPECT_LT(pose->position_mm.z, -5) << pose->name;
    EXPECT_NEAR(pose->position_mm.x, -25, 2);
    EXPECT_NEAR(std::hypot(pose->position_mm.x, pose->position_mm.y), 55, 4);
    EXPECT_THAT(pose->name, HasSubstr("neck"));
  }
}

TEST(StartPose, WithTheChinDownUnderTheChin) {
  PatientCase patient = standingMan();
  for (int k = 0; k < 100; ++k)
    for (int j = 0; j < 100; ++j)
      for (int i = 0; i < 140; ++i) {
        const double x = -210 + 3 * i, y = -150 + 3 * j, z = -150 + 3 * k;
        const bool chin = std::abs(x) < 50 && y > -95 && y < 0 && z > -45 && z < 0;
        const bool raisedShoulders = std::hypot(x / 190, (y - 40) / 60) < 1 && z < -30;
        if (chin || raisedShoulders) patient.labels.at(i, j, k) = kMuscle;
      }
  const auto pose = proposeStartPose(patient);
  ASSERT_TRUE(pose) << pose.error().message;
  EXPECT_THAT(pose->name, HasSubstr("neck"));
  EXPECT_LT(pose->position_mm.z, -44);
  EXPECT_GT(pose->position_mm.z, -74);
}

/// Share of the face of a linear probe under which there is a body 5 mm down.
double contactOf(const PatientCase& patient, const StartPose& pose) {
  int touching = 0;
  for (int x_mm = -19; x_mm <= 19; ++x_mm) {
    const Vec3 p = pose.position_mm + double(x_mm) * pose.lateral + 5.0 * pose.axial;
    touching += sampleNearest(patient.labels, patient.labels.geometry.indexFromPatient() * p) != 0;
  }
  return touching / 39.0;
}

/// A narrow bridge to the right of the midline, as the edge of a muscle or a fold above the shoulder: the probe would
/// touch it with its middle only.
TEST(StartPose, TheFaceLiesOnSkin) {
  PatientCase patient = standingMan();
  for (int k = 0; k < 100; ++k)
    for (int j = 0; j < 50; ++j)
      for (int i = 0; i < 140; ++i) {
        const double x = -210 + 3 * i, y = -150 + 3 * j, z = -150 + 3 * k;
        if (std::abs(x + 25) < 5 && y > -75 && z < 20 && z > -80) patient.labels.at(i, j, k) = kMuscle;
      }
  const auto pose = proposeStartPose(patient);
  ASSERT_TRUE(pose) << pose.error().message;
  EXPECT_GE(contactOf(patient, *pose), 0.9) << pose->name << ", x = " << pose->position_mm.x;
  patient.manifest.targets.push_back({"vein", kVein, {-25, -35, -40}});
  const auto over = proposeStartPose(patient);
  ASSERT_TRUE(over) << over.error().message;
  EXPECT_GE(contactOf(patient, *over), 0.9) << "x = " << over->position_mm.x;
}

/// Without labels, the body is what is denser than air. The neck is short here, with the arms up: above the shoulder a
/// probe could fall into a groove.
TEST(StartPose, OnARealNeckTheFaceLiesOnSkin) {
  INSONATE_NEEDS_DATA("neck-ct-dicom");
  auto imported = importSeries(test::testData("neck-ct-dicom"));
  ASSERT_TRUE(imported) << imported.error().message;
  PatientCase patient;
  patient.ct = std::move(imported->ct);
  patient.labels = LabelMap(patient.ct.geometry);
  const auto pose = proposeStartPose(patient);
  ASSERT_TRUE(pose) << pose.error().message;
  for (std::size_t v = 0; v < patient.ct.voxels.size(); ++v)
    if (patient.ct.voxels[v] > -300) patient.labels.voxels[v] = kSoftTissue;
  EXPECT_GE(contactOf(patient, *pose), 0.9) << pose->name;
  StartPose above = *pose;
  above.position_mm = above.position_mm - 10.0 * above.axial;
  EXPECT_LT(contactOf(patient, above), 0.2) << "at the skin, not in the body";
}

TEST(StartPose, AWaistIsNoNeck) {
  PatientCase patient = standingMan();
  for (int k = 0; k < 100; ++k)
    for (int j = 0; j < 100; ++j)
      for (int i = 0; i < 140; ++i) {
        const double x = -210 + 3 * i, y = -150 + 3 * j, z = -150 + 3 * k;
        const double width_mm = 150 + 30 * std::abs(z) / 150;
        patient.labels.at(i, j, k) = std::hypot(x / width_mm, y / (width_mm - 50)) < 1 ? kMuscle : kBackground;
      }
  const auto pose = proposeStartPose(patient);
  ASSERT_TRUE(pose) << pose.error().message;
  EXPECT_THAT(pose->name, HasSubstr("middle"));
}

TEST(StartPose, WithoutANeckInTheMiddle) {
  PatientCase patient = standingMan();
  for (int k = 0; k < 100; ++k)  // shoulders all the way up
    for (int j = 0; j < 100; ++j)
      for (int i = 0; i < 140; ++i) patient.labels.at(i, j, k) = patient.labels.at(i, j, 5);
  const auto pose = proposeStartPose(patient);
  ASSERT_TRUE(pose) << pose.error().message;
  EXPECT_NEAR(pose->position_mm.z, 0, 4);
  EXPECT_THAT(pose->name, HasSubstr("middle"));
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
  EXPECT_NEAR(std::hypot(pose->position_mm.x, pose->position_mm.y), 50, 1.5);
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
  EXPECT_LT(pose->position_mm.y, -40) << "anterior is -y in LPS whatever the storage order";
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
