#include "line/PleuraSight.h"
#include "support/TestData.h"

#include <insonate/procedure/AttemptRecording.h>
#include <insonate/simulator/AttemptImages.h>
#include <insonate/simulator/AttemptSettings.h>
#include <insonate/simulator/ScriptedSession.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace insonate {
namespace {

using testing::Optional;

/// Muscle from y = 0 on, two lungs and the trachea from y = 15 mm on, and a rib over a part of the right lung. Patient
/// LPS: the right lung is at negative x.
PatientCase chestCase() {
  VolumeGeometry grid;
  grid.size = {141, 51, 33};
  grid.origin_mm = {-70, -6, -16};
  PatientCase patient{{}, CtVolume(grid, -1000), LabelMap(grid)};
  patient.manifest.title = "Chest";
  patient.manifest.startPoses = {{"over the right lung", {-45, 0, 0}, {0, 1, 0}, {1, 0, 0}}};
  patient.manifest.targets = {{"vein", kVein, {-10, 8, 0}}};
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 6; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i) {
        const double x = i - 70, depth = j - 6;
        const bool isGas = depth > 15 && (std::abs(x) > 24 || std::abs(x) < 6);
        const bool isRib = x < -60 && depth > 5 && depth < 9;
        const bool isVein = std::hypot(x + 10, depth - 8) < 4, isArtery = std::hypot(x - 12, depth - 8) < 3;
        const Label label = depth < 2  ? kSkin
                            : isRib    ? kBone
                            : isVein   ? kVein
                            : isArtery ? kArtery
                            : isGas    ? kAirway
                                       : kMuscle;
        patient.labels.at(i, j, k) = label;
        patient.ct.at(i, j, k) = label == kAirway ? -900 : label == kBone ? 900 : 40;
      }
  return patient;
}

PleuraSight sightFrom(double x_mm, double depth_mm, std::optional<BodySide> side,
                      const std::array<double, 2>& detached_mm = {}) {
  static const PatientCase patient = chestCase();
  const ImageField field{.width_mm = 30, .sliceHalf_mm = 1};
  const Vec3 left{1, 0, 0}, down{0, 1, 0};
  const Transform pose{{{left, cross(down, left), down}}, {x_mm, 0, 0}};
  const PlaneDisplacement none;
  return pleuraIn({pose, none, field, depth_mm}, {patient.labels, 0, detached_mm, side});
}

TEST(PleuraSight, IsThatOfTheLungInTheImage) {
  EXPECT_NEAR(sightFrom(-45, 30, BodySide::Right).width_mm, 31, 1);
  EXPECT_EQ(sightFrom(-45, 30, BodySide::Left).width_mm, 0) << "the lung of the other side";
  EXPECT_NEAR(sightFrom(-45, 30, std::nullopt).width_mm, 31, 1);
  EXPECT_EQ(sightFrom(-45, 14, BodySide::Right).width_mm, 0) << "deeper than the image";
  EXPECT_EQ(sightFrom(0, 30, std::nullopt).width_mm, 0) << "the airway";
  EXPECT_NEAR(sightFrom(-60, 30, BodySide::Right).width_mm, 15, 2) << "a rib hides the rest";
}

TEST(PleuraSight, TellsWhereTheLungDoesNotSlide) {
  EXPECT_NEAR(sightFrom(-45, 30, BodySide::Right, {45, 0}).still_mm, 15, 1);
  EXPECT_EQ(sightFrom(-45, 30, BodySide::Right, {0, 90}).still_mm, 0) << "the left lung";
  EXPECT_NEAR(sightFrom(45, 30, BodySide::Left, {0, 90}).still_mm, 31, 1);
}

TEST(Pneumothorax, GrowsFromTheTracheaToTheSide) {
  insonate::Pneumothorax pneumothorax;  // not the event
  EXPECT_EQ(pneumothorax.detachedAt_mm(100), (std::array{0.0, 0.0}));
  pneumothorax.since_s[0] = 10;
  EXPECT_EQ(pneumothorax.detachedAt_mm(9), (std::array{0.0, 0.0})) << "before the puncture";
  EXPECT_EQ(pneumothorax.detachedAt_mm(20), (std::array{30.0, 0.0}));
  EXPECT_EQ(pneumothorax.detachedAt_mm(1000), (std::array{150.0, 0.0}));
}

/// The needle at x goes 20 mm into the body.
class PunctureOfTheChest : public testing::Test {
 protected:
  SessionOutcome puncture(double x_mm) {
    const std::string x = std::to_string(x_mm);
    const auto script = readSessionScript(
        R"({"procedure": "internal_jugular", "acts": [
          {"probe": {"position_mm": [-45, 0.5, 0], "axial": [0, 1, 0], "lateral": [1, 0, 0]}},
          {"needle": {"from_mm": [)" +
            x + R"(, -5, 0], "to": [)" + x + R"(, 20, 0]}}, {"advance_mm": 25}, {"wait_s": 0.3},
          {"withdraw_mm": 10}, {"advance_mm": 10}, {"wait_s": 0.3}]})",
        *patient);
    EXPECT_TRUE(script) << script.error().message;
    images.clear();
    const SessionImages pictures{.every_us = 500'000, .take = [&](const LiveFrame& frame) -> Result<void> {
                                   images.emplace_back(std::llround(frame.time_s * 1e6), frame.image.gray);
                                   return {};
                                 }};
    auto outcome = runSession(*script, *patient, "insonate test", folder / "attempt", {}, pictures);
    if (!outcome) throw std::runtime_error(outcome.error().message);
    return std::move(*outcome);
  }
  static std::vector<AttemptEvent> eventsOf(const SessionOutcome& outcome) {
    std::vector<AttemptEvent> found;
    std::ranges::copy_if(outcome.events, std::back_inserter(found),
                         [](const AttemptEvent& event) { return event.kind == AttemptEventKind::Pneumothorax; });
    return found;
  }

  const std::shared_ptr<const PatientCase> patient = std::make_shared<const PatientCase>(chestCase());
  const test::TemporaryFolder folder;
  std::vector<std::pair<std::int64_t, std::vector<std::uint8_t>>> images;
};

TEST_F(PunctureOfTheChest, OfTheLungCausesAPneumothoraxOnce) {
  const SessionOutcome outcome = puncture(-45);
  const std::vector<AttemptEvent> events = eventsOf(outcome);
  ASSERT_EQ(events.size(), 1U) << "the second puncture is of the same lung";
  EXPECT_EQ(outcome.metrics[Metric::Pneumothoraces], 1);
  EXPECT_EQ(outcome.metrics[Metric::LungPunctures], 2);
  EXPECT_THAT(outcome.run.findings(), testing::Contains(testing::Truly([&](const ProcedureRun::Finding& finding) {
                return outcome.run.procedure().rules[finding.rule].name == "pneumothorax";
              })));
  auto recording = AttemptRecording::open(folder / "attempt");
  ASSERT_TRUE(recording) << recording.error().message;
  const auto settings = parseAttemptSettings(*recording->settingsAt(events[0].time_us + 100'000));
  ASSERT_TRUE(settings) << settings.error().message;
  const double since_s = static_cast<double>(events[0].time_us) * 1e-6;
  EXPECT_THAT(settings->pneumothorax.since_s[0], Optional(since_s));
  EXPECT_FALSE(settings->pneumothorax.since_s[1]);
  EXPECT_NEAR(settings->lung(since_s + 4).detached_mm[0], 12, 1e-9);
  auto replay = AttemptImages::make(std::make_shared<const AttemptRecording>(std::move(*recording)), patient);
  ASSERT_TRUE(replay) << replay.error().message;
  for (auto it = images.rbegin(); it != images.rend(); ++it)
    EXPECT_EQ((*replay->at(it->first))->image.gray, it->second);
}

TEST_F(PunctureOfTheChest, OfTheTracheaCausesNone) {
  const SessionOutcome outcome = puncture(0);
  EXPECT_THAT(eventsOf(outcome), testing::IsEmpty());
  EXPECT_EQ(outcome.metrics[Metric::Pneumothoraces], 0);
  EXPECT_GT(*outcome.metrics[Metric::LungPunctures], 0);
}

}  // namespace
}  // namespace insonate
