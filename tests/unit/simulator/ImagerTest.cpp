#include "support/SmallCase.h"

#include <insonate/simulator/Imager.h>
#include <insonate/simulator/ProbePose.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <numeric>

namespace insonate {
namespace {

using testing::HasSubstr;

ImagingSetup smallSetup() {
  ImagingSetup setup{*loadProbe("linear"), {}, *loadAcousticTable("neck"), engineNames().front()};
  setup.settings = settingsFor(setup.probe);
  setup.settings.depth_mm = 30;
  setup.settings.scanlines = 48;
  setup.settings.samples = 200;
  setup.settings.elevationPlanes = 1;
  setup.settings.looks = 1;
  setup.settings.width = 160;
  setup.settings.height = 120;
  return setup;
}

Transform poseAt(Vec3 position_mm) {
  return *patientFromProbe(position_mm, {0, 1, 0}, {1, 0, 0});
}

ImagingFrame rendered(const ImagingSetup& setup, const Transform& pose) {
  const PatientCase patient = test::smallCase();
  auto imager = Imager::make(setup);
  EXPECT_TRUE(imager) << imager.error().message;
  auto scene = makeScene(patient, setup, regionOf(setup.probe, setup.settings, pose));
  EXPECT_TRUE(scene) << scene.error().message;
  ImagingFrame frame;
  if (imager && scene) imager->render(**scene, pose, frame);
  return frame;
}

double meanGray(const BModeImage& image, double lateral_mm, double depth_mm, double radius_mm) {
  double sum = 0;
  int count = 0;
  for (int row = 0; row < image.height; ++row)
    for (int column = 0; column < image.width; ++column) {
      const double x = image.left_mm + column * image.pixel_mm - lateral_mm;
      const double z = image.top_mm + row * image.pixel_mm - depth_mm;
      if (std::hypot(x, z) > radius_mm) continue;
      sum += image.gray[std::size_t(row) * image.width + column];
      ++count;
    }
  return sum / std::max(count, 1);
}

TEST(Imager, ColorLeavesEnvelopeAndGrayImageAsTheyAre) {
  ImagingSetup setup = smallSetup();
  const ImagingFrame plain = rendered(setup, poseAt({3, 0, 0}));
  EXPECT_TRUE(plain.color.empty());
  EXPECT_EQ(std::ranges::count(plain.stages, "color", &ImagingFrame::Stage::name), 0);
  setup.color = colorSettingsFor(setup.probe, setup.settings);
  const ImagingFrame colored = rendered(setup, poseAt({3, 0, 0}));
  EXPECT_FALSE(colored.color.empty());
  EXPECT_EQ(colored.image.gray, plain.image.gray);
  EXPECT_EQ(colored.envelope.amplitude, plain.envelope.amplitude);
  setup.color->right = setup.color->left;
  const auto refused = Imager::make(setup);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("right must exceed left"));
}

TEST(Imager, ShowsTheVeinDarkAndWhereItIs) {
  const ImagingSetup setup = smallSetup();
  const ImagingFrame frame = rendered(setup, poseAt({3, 0, 0}));
  ASSERT_EQ(frame.image.width, 160);
  ASSERT_EQ(frame.image.height, 120);
  EXPECT_EQ(frame.envelope.scanlines, 48);
  EXPECT_EQ(frame.envelope.samples, 200);
  const double vein = meanGray(frame.image, -3, 12, 3), besides = meanGray(frame.image, 8, 12, 3);
  EXPECT_GT(besides, 20);
  EXPECT_LT(vein, besides / 2);
}

TEST(Imager, TellsItsStagesAndTime) {
  const ImagingFrame frame = rendered(smallSetup(), poseAt({}));
  EXPECT_GT(frame.frame_ms, 0);
  EXPECT_GE(frame.stages.size(), 5u);
  EXPECT_EQ(frame.stages.back().name, "scan_convert");
}

TEST(Imager, SamePoseGivesTheSamePictureFromAnotherSceneRegion) {
  const ImagingSetup setup = smallSetup();
  const PatientCase patient = test::smallCase();
  const Transform pose = poseAt({0, 0, 0});
  const ImagingFrame alone = rendered(setup, pose);
  Region wide = regionOf(setup.probe, setup.settings, pose);
  wide.low_mm = wide.low_mm - Vec3{7, 7, 7};
  wide.high_mm = wide.high_mm + Vec3{7, 7, 7};
  const auto scene = makeScene(patient, setup, wide);
  ASSERT_TRUE(scene);
  auto imager = Imager::make(setup);
  ImagingFrame shared;
  imager->render(**scene, pose, shared);
  EXPECT_EQ(alone.envelope.amplitude, shared.envelope.amplitude);
  EXPECT_EQ(alone.image.gray, shared.image.gray);
}

TEST(Imager, TellsWhichEngineComputedAndWhy) {
  ImagingSetup setup = smallSetup();
  EXPECT_EQ(rendered(setup, poseAt({0, 0, 0})).engine, "reference");
  setup.engine = "auto";
  const ImagingFrame frame = rendered(setup, poseAt({0, 0, 0}));
  EXPECT_THAT(frame.engine, testing::AnyOf("cpu", "glsl"));
  EXPECT_THAT(frame.engineNote, testing::EndsWith("."));
}

TEST(Imager, RefusesAnUnknownEngineAndAbsurdSettings) {
  ImagingSetup setup = smallSetup();
  setup.engine = "warp";
  const auto unknown = Imager::make(setup);
  ASSERT_FALSE(unknown);
  EXPECT_THAT(unknown.error().message, HasSubstr("warp"));

  setup = smallSetup();
  setup.settings.samples = 0;
  const auto absurd = Imager::make(setup);
  ASSERT_FALSE(absurd);
  EXPECT_THAT(absurd.error().message, HasSubstr("samples"));
}

TEST(SceneRuns, ShareASceneWhileTheProbeStaysNear) {
  const ImagingSetup setup = smallSetup();
  std::vector<Transform> path;
  for (int i = 0; i < 5; ++i) path.push_back(poseAt({0.1 * i, 0, 0}));
  path.push_back(poseAt({500, 0, 0}));
  const auto runs = sceneRuns(setup, path);
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_EQ(runs[0].first, 0u);
  EXPECT_EQ(runs[0].count, 5u);
  EXPECT_EQ(runs[1].first, 5u);
  EXPECT_EQ(runs[1].count, 1u);
}

TEST(SceneRuns, CoverEveryFramesRegion) {
  const ImagingSetup setup = smallSetup();
  std::vector<Transform> path;
  for (int i = 0; i < 40; ++i) path.push_back(poseAt({0, 0, 3.0 * i}));
  const auto runs = sceneRuns(setup, path);
  EXPECT_GT(runs.size(), 1u);
  std::size_t next = 0;
  for (const SceneRun& run : runs) {
    EXPECT_EQ(run.first, next);
    next += run.count;
    for (std::size_t i = run.first; i < next; ++i) {
      const Region needed = regionOf(setup.probe, setup.settings, path[i]);
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_LE(run.region.low_mm[axis], needed.low_mm[axis]);
        EXPECT_GE(run.region.high_mm[axis], needed.high_mm[axis]);
      }
    }
  }
  EXPECT_EQ(next, path.size());
}

TEST(CheckReach, NamesThePoseThatSeesNothing) {
  const PatientCase patient = test::smallCase();
  const ImagingSetup setup = smallSetup();
  EXPECT_TRUE(checkPosesTouchVolume(patient, setup, std::vector{poseAt({}), poseAt({20, 5, 3})}));
  const auto lost = checkPosesTouchVolume(patient, setup, std::vector{poseAt({}), poseAt({1000, 0, 0})});
  ASSERT_FALSE(lost);
  EXPECT_THAT(lost.error().message, testing::AllOf(HasSubstr("Pose 1"), HasSubstr("1000"), HasSubstr("auto")));
  EXPECT_FALSE(checkPosesTouchVolume(patient, setup, std::vector{poseAt({0, 1e300, 0})}));
}

}  // namespace
}  // namespace insonate
