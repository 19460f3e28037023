#include "CaseSamples.h"

#include <insonate/cases/CropCase.h>

#include <gmock/gmock.h>

#include <algorithm>

namespace insonate {
namespace {

using testing::HasSubstr;

double ramp(Vec3 p) {
  return 100 + 3 * p.x - 2 * p.y + 4 * p.z;
}

/// HU as a linear function of place, on an oblique, anisotropic grid of either handedness.
PatientCase rampCase(bool leftHanded) {
  VolumeGeometry g = test::grid({24, 20, 12}, {0.8, 1.1, 2.5}, {-30, 12, 40});
  g.direction = test::obliqueDirection();
  if (leftHanded) g.direction.column[2] = -g.direction.column[2];
  PatientCase patient{{}, CtVolume(g), LabelMap(g)};
  for (int k = 0; k < 12; ++k)
    for (int j = 0; j < 20; ++j)
      for (int i = 0; i < 24; ++i)
        patient.ct.at(i, j, k) =
            static_cast<std::int16_t>(std::lround(ramp(g.patientFromIndex() * Vec3{double(i), double(j), double(k)})));
  return patient;
}

TEST(CropCase, APartHoldsTheSameVoxelsAtTheSamePlaces) {
  PatientCase patient = test::noiseCase(test::grid({9, 8, 7}, {0.5, 1, 2}, {-3, 4, 5}));
  patient.colors = {{kVein, {1, 2, 3}}};
  patient.manifest.startPoses = {{"pose", {900, 0, 0}, {0, 1, 0}, {1, 0, 0}}};
  const VoxelBox box{{2, 1, 3}, {7, 8, 5}};
  const auto part = cropCase(patient, {box, {}});
  ASSERT_TRUE(part) << part.error().message;
  EXPECT_EQ(part->ct.voxels, cropped(patient.ct, box).voxels);
  EXPECT_EQ(part->labels.voxels, cropped(patient.labels, box).voxels);
  EXPECT_EQ(part->ct.geometry.origin_mm, (Vec3{-2, 5, 11}));
  EXPECT_EQ(part->colors, patient.colors);
  ASSERT_EQ(part->manifest.startPoses.size(), 1U) << "a probe stands on the skin, also outside";
  EXPECT_EQ(part->manifest.startPoses[0].position_mm, (Vec3{900, 0, 0}));
  EXPECT_THAT(part->manifest.importNotes,
              testing::ElementsAre("Cropped from 9x8x7 voxels of 0.5x1x2 mm to 5x7x2 voxels of 0.5x1x2 mm."));
}

TEST(CropCase, ResamplingKeepsPlaces) {
  for (const bool leftHanded : {false, true})
    for (const Vec3 spacing : {Vec3{0.4, 0.55, 1}, Vec3{1.7, 1.7, 1.7}, Vec3{2.4, 3.3, 5}}) {
      const PatientCase patient = rampCase(leftHanded);
      const auto part = cropCase(patient, {{{2, 2, 1}, {22, 18, 11}}, spacing});
      ASSERT_TRUE(part) << part.error().message;
      const VolumeGeometry& g = part->ct.geometry;
      EXPECT_EQ(g.spacing_mm, spacing);
      for (int a = 0; a < 3; ++a) {
        const double before_mm = std::array{20, 16, 10}[a] * patient.ct.geometry.spacing_mm[a];
        EXPECT_NEAR(g.size[a] * spacing[a], before_mm, spacing[a] / 2 + 1e-9);
      }
      for (int k = 0; k < g.size[2]; ++k)
        for (int j = 0; j < g.size[1]; ++j)
          for (int i = 0; i < g.size[0]; ++i)
            ASSERT_NEAR(part->ct.at(i, j, k), ramp(g.patientFromIndex() * Vec3{double(i), double(j), double(k)}), 1.01);
    }
}

TEST(CropCase, TheLabelWithTheLargestShareWins) {
  PatientCase patient;
  patient.ct = CtVolume(test::grid({6, 1, 1}), 0);
  patient.labels = LabelMap(patient.ct.geometry);
  patient.labels.voxels = {kVein, kVein, kArtery, kBone, kBone, kArtery};
  const auto coarse = cropCase(patient, {boxOf(patient.ct.geometry), Vec3{3, 1, 1}});
  ASSERT_TRUE(coarse) << coarse.error().message;
  EXPECT_THAT(coarse->labels.voxels, testing::ElementsAre(kVein, kBone));
  const auto fine = cropCase(patient, {boxOf(patient.ct.geometry), Vec3{0.5, 1, 1}});
  ASSERT_TRUE(fine) << fine.error().message;
  EXPECT_THAT(fine->labels.voxels, testing::ElementsAre(kVein, kVein, kVein, kVein, kArtery, kArtery, kBone, kBone,
                                                        kBone, kBone, kArtery, kArtery));
}

/// A wall of one voxel vanished between two vessels when the voxels became larger.
TEST(CropCase, AWallBetweenVeinAndArteryStays) {
  PatientCase patient;
  patient.ct = CtVolume(test::grid({12, 1, 1}, {0.5, 1, 1}), 0);
  patient.labels = LabelMap(patient.ct.geometry);
  patient.labels.voxels = {kFat,        kVein,   kVein,   kVein,   kVein,   kVein,
                           kSoftTissue, kArtery, kArtery, kArtery, kArtery, kFat};
  const auto coarse = cropCase(patient, {boxOf(patient.ct.geometry), Vec3{1.5, 1, 1}});
  ASSERT_TRUE(coarse) << coarse.error().message;
  EXPECT_THAT(coarse->labels.voxels, testing::ElementsAre(kVein, kVein, kSoftTissue, kArtery));
  EXPECT_EQ(coarse->manifest.importNotes.size(), 1U);
}

TEST(CropCase, VesselsThatTouchOnlyInTheNewGridAreNamed) {
  PatientCase patient;
  patient.ct = CtVolume(test::grid({40, 1, 1}, {0.1, 1, 1}), 0);
  patient.labels = LabelMap(patient.ct.geometry, kVein);
  std::fill(patient.labels.voxels.begin() + 20, patient.labels.voxels.end(), std::uint8_t(kArtery));
  const CropOptions options{boxOf(patient.ct.geometry), Vec3{2, 1, 1}};
  const auto before = cropCase(patient, options);
  ASSERT_TRUE(before) << before.error().message;
  EXPECT_EQ(before->manifest.importNotes.size(), 1U) << "they touch in the case, too";
  patient.labels.voxels[19] = kSoftTissue;
  const auto coarse = cropCase(patient, options);
  ASSERT_TRUE(coarse);
  EXPECT_THAT(coarse->labels.voxels, testing::ElementsAre(kVein, kArtery));
  EXPECT_THAT(coarse->manifest.importNotes, testing::Contains(HasSubstr("Vein and artery touch at 1 voxel,")));
}

TEST(CropCase, SpacingsInTheNoteAreRounded) {
  const PatientCase patient = test::noiseCase(test::grid({9, 8, 7}, {0.9765625, 0.9765625, 4.25}));
  const auto part = cropCase(patient, {boxOf(patient.ct.geometry), {}});
  ASSERT_TRUE(part);
  EXPECT_THAT(part->manifest.importNotes, testing::ElementsAre(HasSubstr("9x8x7 voxels of 0.977x0.977x4.25 mm to")));
}

TEST(CropCase, ACoarserCtIsAMeanNotASample) {
  PatientCase patient;
  patient.ct = CtVolume(test::grid({8, 1, 1}), 0);
  patient.labels = LabelMap(patient.ct.geometry);
  for (int i = 0; i < 8; i += 2) patient.ct.at(i, 0, 0) = 1000;  // the finest pattern: 500 on average
  const auto coarse = cropCase(patient, {boxOf(patient.ct.geometry), Vec3{2, 1, 1}});
  ASSERT_TRUE(coarse);
  for (const std::int16_t hu : coarse->ct.voxels) EXPECT_NEAR(hu, 500, 260) << "never 0 or 1000";
  EXPECT_EQ(coarse->ct.voxels[1], 500);
}

TEST(CropCase, TargetsAndLandmarksOutsideAreDroppedAndSaid) {
  PatientCase patient = test::cylinderNeck();
  patient.manifest.targets.push_back({"left vein", kVein, {30, -22, 0}});
  patient.manifest.landmarks = {{"cricoid", "", {-5, -30, 0}}, {"puncture_site", "left site", {30, -30, 0}}};
  const VoxelBox left = boxBetween(patient.ct.geometry, {-60, -60, -10}, {0.2, 60, 10});
  EXPECT_EQ(left, (VoxelBox{{0, 0, 20}, {61, 121, 41}}));
  const auto part = cropCase(patient, {left, {}});
  ASSERT_TRUE(part);
  ASSERT_EQ(part->manifest.targets.size(), 1U);
  EXPECT_EQ(part->manifest.targets[0].position_mm, (Vec3{-30, -22, 0}));
  EXPECT_THAT(part->manifest.importNotes, testing::Contains(HasSubstr("\"left vein\" was outside")));
  ASSERT_EQ(part->manifest.landmarks.size(), 1U);
  EXPECT_EQ(part->manifest.landmarks[0].code, "cricoid");
  EXPECT_THAT(part->manifest.importNotes, testing::Contains(HasSubstr("landmark \"left site\" was outside")));
}

TEST(CropCase, ImpossibleRegionsAndSpacingsAreRefused) {
  const PatientCase patient = test::noiseCase(test::grid({6, 6, 6}));
  const VoxelBox all = boxOf(patient.ct.geometry);
  EXPECT_THAT(cropCase(patient, {{{2, 2, 2}, {2, 4, 4}}, {}}).error().message, HasSubstr("contains no voxel"));
  EXPECT_THAT(cropCase(patient, {{{0, 0, 0}, {7, 6, 6}}, {}}).error().message, HasSubstr("beyond"));
  EXPECT_THAT(cropCase(patient, {all, Vec3{0, 1, 1}}).error().message, HasSubstr("mm"));
  EXPECT_THAT(cropCase(patient, {all, Vec3{1, -1, 1}}).error().message, HasSubstr("mm"));
  const VolumeGeometry huge = test::grid({4000, 4000, 4000}, {20, 20, 20});
  EXPECT_THAT(croppedGrid(huge, {boxOf(huge), Vec3{0.1, 0.1, 0.1}}).error().message, HasSubstr("larger spacing"));
  EXPECT_TRUE(boxBetween(patient.ct.geometry, {100, 100, 100}, {200, 200, 200}).empty());
  const auto stop = [](std::string_view, double) { return false; };
  EXPECT_EQ(cropCase(patient, {all, {}}, stop).error().message, kCancelled);
}

}  // namespace
}  // namespace insonate
