#include "Waiting.h"

#include <insonate/simulator/ProbePose.h>
#include <insonate/tissue/AcousticTable.h>
#include <insonate/ui/CaseWorker.h>
#include <insonate/ui/LiveFeed.h>
#include <insonate/ui/TaskBar.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <support/SmallCase.h>

#include <chrono>
#include <memory>
#include <optional>

namespace {

using namespace insonate;
using std::chrono::milliseconds;

/// A case whose skin takes a while to find.
std::shared_ptr<const PatientCase> largeCase() {
  VolumeGeometry grid;
  grid.size = {256, 256, 128};
  auto patient = std::make_shared<PatientCase>(PatientCase{{}, CtVolume(grid, 0), LabelMap(grid)});
  for (std::size_t n = 0; n < patient->labels.voxels.size(); ++n) patient->labels.voxels[n] = kBone;
  patient->manifest.startPoses = {{"start", {128, 0, 64}, {0, 1, 0}, {1, 0, 0}}};
  return patient;
}

TEST(CaseWorker, DeliversInOrderOnTheWindowsThread) {
  std::string order;
  ui::CaseCallbacks work;
  work.start = [&](const StartPose&) { order += "start "; };
  work.hand = [&](const ProbePlacement&) { order += "hand "; };
  work.surface = [&](std::uint8_t label, const auto&) { order += std::to_string(label) + " "; };
  work.surfacesDone = [&] { order += "done"; };
  ui::CaseWorker worker(std::make_shared<PatientCase>(test::smallCase()), work, {{kVein, {}}, {kThyroid, {}}});
  ASSERT_TRUE(test::waitUntil([&] { return order.ends_with("done"); })) << order;
  EXPECT_EQ(order, "start hand " + std::to_string(kVein) + " done");
  worker.requestSurfaces({{kBone, {}}});
  EXPECT_TRUE(test::waitUntil([&] { return order.ends_with(std::to_string(kBone) + " done"); })) << order;
}

TEST(CaseWorker, MakesAllOfTissuesWhereTheyAreRequested) {
  const auto patient = std::make_shared<const PatientCase>(test::smallCaseWithOwnLabel(kBone));
  std::vector<std::uint8_t> structures;
  std::shared_ptr<const LabelMap> tissues;
  ui::CaseCallbacks work;
  work.structures = [&](const std::vector<std::uint8_t>& labels) { structures = labels; };
  const auto madeOf = [&] {
    structures.clear();
    const ui::CaseWorker worker(patient, work, {});
    EXPECT_TRUE(test::waitUntil([&] { return !structures.empty(); }));
    return structures;
  };
  EXPECT_THAT(madeOf(), testing::AllOf(testing::Contains(test::kOwnLabel), testing::Not(testing::Contains(kBone))));
  work.tissues = [&](std::shared_ptr<const LabelMap> labels) { tissues = std::move(labels); };
  EXPECT_THAT(madeOf(), testing::AllOf(testing::Contains(kBone), testing::Not(testing::Contains(test::kOwnLabel))));
  EXPECT_EQ(tissues->voxels, test::smallCase().labels.voxels);
}

TEST(CaseWorker, GoesWithoutWaitingForItsStepAndNothingComesLater) {
  ASSERT_TRUE(ui::waitForJobs(milliseconds(5000)));
  bool begun = false;
  int came = 0;
  auto patient = largeCase();
  const std::weak_ptr<const PatientCase> held = patient;
  ui::CaseCallbacks work;
  work.start = [&](const StartPose&) { begun = true; };
  work.hand = [&](const ProbePlacement&) { ++came; };
  work.failed = [&](const QString&) { ++came; };
  work.surface = [&](std::uint8_t, const auto&) { ++came; };
  auto worker = std::make_unique<ui::CaseWorker>(std::move(patient), work,
                                                 std::vector<ui::SurfaceRequest>{{kBone, {}}, {kSkin, {}}});
  ASSERT_TRUE(test::waitUntil([&] { return begun; }));
  worker.reset();
  EXPECT_FALSE(ui::waitForJobs(milliseconds(0))) << "the window waited";
  EXPECT_TRUE(ui::waitForJobs(milliseconds(20000)));
  EXPECT_TRUE(held.expired());
  test::waitUntil([] { return false; }, 20);
  EXPECT_EQ(came, 0);
}

/// The scan cuts the body in front, and its only skin looks to the head: away from where skin is looked for first.
TEST(CaseWorker, AProbeThatIsToBePlacedStandsSquareToTheSkin) {
  auto patient = std::make_shared<PatientCase>(test::smallCase());
  patient->manifest.startPoses.clear(), patient->manifest.targets.clear();
  const auto& size = patient->labels.geometry.size;
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i) {
        patient->labels.at(i, j, k) = k < 12 ? kSoftTissue : kBackground;
        patient->ct.at(i, j, k) = k < 12 ? 30 : -1000;
      }
  std::optional<ProbePlacementState> held;
  ui::CaseCallbacks work;
  work.hand = [](const ProbePlacement&) { FAIL() << "a start was found"; };
  work.unplaced = [&](const ProbePlacement& hand, const QString&) { held = hand.state(); };
  const ui::CaseWorker worker(patient, work, {});
  ASSERT_TRUE(test::waitUntil([&] { return held.has_value(); }));
  EXPECT_NEAR(held->inward.z, -1, 1e-6);
  EXPECT_NEAR(held->tilt_deg, 0, 1e-6);
  EXPECT_NEAR(held->rock_deg, 0, 1e-6);
}

TEST(CaseWorker, AReplacedProbeEndsByItself) {
  auto patient = std::make_shared<const PatientCase>(test::smallCase());
  const std::weak_ptr<const PatientCase> held = patient;
  ImagingSetup setup;
  setup.probe = loadProbe("linear").value();
  setup.settings = settingsFor(setup.probe);
  setup.tissues = loadAcousticTable(acousticPresetNames().front()).value();
  const StartPose start = patient->manifest.startPoses.front();
  const auto pose = patientFromProbe(start.position_mm, start.axial, start.lateral).value();
  int news = 0;
  ui::LiveFeed feed([&] { ++news; });
  for (int times = 0; times < 3; ++times) feed.setImaging(LiveImaging::make(patient, setup, pose).value());
  EXPECT_TRUE(test::waitUntil([&] { return feed.imaging()->latest() != nullptr && news > 0; }, test::kPatience_ms));
  feed.setImaging(nullptr);
  EXPECT_FALSE(ui::waitForJobs(milliseconds(0))) << "the window waited";
  patient.reset();
  news = 0;
  EXPECT_TRUE(ui::waitForJobs(milliseconds(5000)));
  EXPECT_TRUE(held.expired());
  test::waitUntil([] { return false; }, 20);
  EXPECT_EQ(news, 0);
}

}  // namespace
