#include "line/SalineBubbles.h"
#include "support/SmallCase.h"
#include "support/TestData.h"

#include <insonate/procedure/AttemptRecording.h>
#include <insonate/simulator/AttemptImages.h>
#include <insonate/simulator/AttemptSettings.h>
#include <insonate/simulator/ScriptedSession.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>

namespace insonate {
namespace {

/// A right internal jugular vein of 5 mm radius along the body, which joins a wider vein, and an artery beside it. The
/// head is toward +z.
std::vector<NamedVessel> bubbleVessels() {
  NamedVessel jugular{.name = "right internal jugular vein", .label = kVein, .course = {}};
  NamedVessel next{.name = "right brachiocephalic vein", .label = kVein, .course = {}};
  NamedVessel artery{.name = "right common carotid artery", .label = kArtery, .course = {}};
  for (int z = 60; z >= -40; z -= 10) jugular.course.push_back({{0, 12, double(z)}, 5});
  for (int z = -40; z >= -400; z -= 10) next.course.push_back({{0, 12, double(z)}, 7});
  for (int z = 200; z >= -200; z -= 10) artery.course.push_back({{-15, 12, double(z)}, 5});
  return {jugular, next, artery};
}

/// 390 ml/min through a circle of 5 mm, and a parabolic profile.
constexpr double kFastest_mmps = 2 * 6500 / (std::numbers::pi * 25);
const SalineFlush kFlush{.time_s = 7, .wall = kVein, .from_mm = {0, 12, 0}};

std::vector<Bubble> bubblesAt(double age_s, const SalineFlush& flush = kFlush, const LabelMap* labels = nullptr) {
  SalineBubbles bubbles(bubbleVessels(), labels);
  const auto shown = bubbles.at(flush, age_s, {}, std::nullopt);
  return {shown.begin(), shown.end()};
}

double totalOf(const std::vector<Bubble>& bubbles) {
  double sum = 0;
  for (const Bubble& bubble : bubbles) sum += bubble.amplitude;
  return sum;
}

TEST(SalineBubbles, MoveWithTheBloodOfTheirVessel) {
  constexpr double kAge_s = 0.2, kJet_mm = 2;
  const std::vector<Bubble> bubbles = bubblesAt(kAge_s);
  EXPECT_NEAR(static_cast<double>(bubbles.size()), 1500 * kAge_s / SalineBubbles::kInjection_s, 2);
  double farthest_mm = 0, sum_mm = 0;
  for (const Bubble& bubble : bubbles) {
    farthest_mm = std::max(farthest_mm, -bubble.position_mm.z), sum_mm -= bubble.position_mm.z;
    EXPECT_LE(std::hypot(bubble.position_mm.x, bubble.position_mm.y - 12), 4.5 + 1e-9);
  }
  EXPECT_LT(farthest_mm, kFastest_mmps * kAge_s + kJet_mm);
  EXPECT_GT(farthest_mm, 0.75 * kFastest_mmps * kAge_s);
  // Over a disc of 0.9 radii the mean of 1 - r^2 is 0.595; on average they are half as old as the flush.
  EXPECT_NEAR(sum_mm / static_cast<double>(bubbles.size()), 0.595 * kFastest_mmps * kAge_s / 2, 1);
}

TEST(SalineBubbles, GoOnIntoTheVeinThatTheirsJoins) {
  const std::vector<Bubble> bubbles = bubblesAt(1.5);
  EXPECT_TRUE(std::ranges::any_of(bubbles, [](const Bubble& bubble) { return bubble.position_mm.z < -80; }));
  EXPECT_TRUE(std::ranges::none_of(bubbles, [](const Bubble& bubble) { return bubble.position_mm.z > 2.1; }));
}

TEST(SalineBubbles, FlowTowardTheHeadInTheCarotid) {
  const std::vector<Bubble> bubbles = bubblesAt(1, {.time_s = 7, .wall = kArtery, .from_mm = {-15, 12, 0}});
  EXPECT_TRUE(std::ranges::any_of(bubbles, [](const Bubble& bubble) { return bubble.position_mm.z > 40; }));
  for (const Bubble& bubble : bubbles) {
    EXPECT_LT(std::hypot(bubble.position_mm.x + 15, bubble.position_mm.y - 12), 5);
    EXPECT_GT(bubble.position_mm.z, -2.1);
  }
}

TEST(SalineBubbles, DoNotDependOnTheTimesThatWereAskedForBefore) {
  SalineBubbles asked(bubbleVessels());
  for (const double age_s : {0.31, 1.7, 4.9, 0.05, 2.345})
    asked.at(kFlush, age_s, {}, 11.0), asked.at({.time_s = 3}, age_s, {}, std::nullopt);
  SalineBubbles fresh(bubbleVessels());
  for (const double age_s : {1.013, 2.345}) {
    const auto a = asked.at(kFlush, age_s, {}, 11.0), b = fresh.at(kFlush, age_s, {}, 11.0);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_EQ(a[i].position_mm, b[i].position_mm);
      EXPECT_EQ(a[i].amplitude, b[i].amplitude);
    }
  }
}

TEST(SalineBubbles, FadeWithinFiveSeconds) {
  const SalineFlush standing{.time_s = 7, .wall = kVein, .from_mm = {0, 12, 0}};
  SalineBubbles still({});
  const auto total = [&](double age_s) {
    const auto shown = still.at(standing, age_s, {}, std::nullopt);
    return totalOf({shown.begin(), shown.end()});
  };
  EXPECT_EQ(total(-0.1), 0) << "before the flush";
  EXPECT_GT(total(1), 0);
  EXPECT_LT(total(4), 0.6 * total(2.5));
  EXPECT_EQ(total(SalineBubbles::kLife_s), 0);
}

TEST(SalineBubbles, StayAtTheTipInAVesselWithoutAName) {
  SalineBubbles unnamed({});
  const auto shown = unnamed.at(kFlush, 2, {}, 1.0);
  ASSERT_FALSE(shown.empty());
  for (const Bubble& bubble : shown) EXPECT_LT(norm(bubble.position_mm - kFlush.from_mm), 3.5);
}

TEST(SalineBubbles, AreOnlyInTheLumenOfTheCase) {
  PatientCase patient = test::smallAttemptCase();
  const auto shown = bubblesAt(0.5, kFlush, &patient.labels);
  ASSERT_FALSE(shown.empty());
  for (const Bubble& bubble : shown) EXPECT_LT(std::hypot(bubble.position_mm.x, bubble.position_mm.y - 12), 5.2);
  std::ranges::fill(patient.labels.voxels, std::uint8_t{kMuscle});
  EXPECT_TRUE(bubblesAt(0.5, kFlush, &patient.labels).empty());
}

/// The probe lies across the vessels, 4 mm toward the feet of the needle's tip.
class BubblesInASession : public testing::Test {
 protected:
  using Images = std::map<std::int64_t, std::vector<std::uint8_t>>;

  BubblesInASession() {
    PatientCase made = test::smallCase();
    for (int k = 0; k < made.labels.geometry.size[2]; ++k)
      for (int j = 6; j < 30; ++j)
        for (int i = 0; i < 20; ++i)
          if (std::hypot(i - 9, j - 18) < 5) made.labels.at(i, j, k) = kArtery;
    made.manifest.vessels = bubbleVessels();
    made.manifest.targets = {{"right internal jugular vein", kVein, {0, 12, 0}}};
    patient = std::make_shared<const PatientCase>(std::move(made));
  }
  /// The needle at x goes into the vessel below; `before`: acts before the flush.
  SessionOutcome flush(double x_mm, const std::string& before = "", const std::string& act = "flush for bubbles",
                       double advance_mm = 17) {
    const std::string x = std::to_string(x_mm);
    file = folder / ("attempt-" + std::to_string(++runs_));
    const auto script = readSessionScript(
        R"({"procedure": "internal_jugular_line", "acts": [
          {"probe": {"position_mm": [0, 0.5, -4], "axial": [0, 1, 0], "lateral": [1, 0, 0]}},
          {"needle": {"from_mm": [)" +
            x + R"(, -5, 0], "to": [)" + x + R"(, 12, 0]}}, {"advance_mm": )" + std::to_string(advance_mm) +
            R"(}, {"wait_s": 0.2},)" + before + R"( {"perform": ")" + act + R"("}, {"wait_s": 1.4}]})",
        *patient);
    EXPECT_TRUE(script) << script.error().message;
    images.clear();
    const SessionImages pictures{.every_us = 200'000, .take = [&](const LiveFrame& frame) -> Result<void> {
                                   images[std::llround(frame.time_s * 1e6)] = frame.image.gray;
                                   return {};
                                 }};
    auto outcome = runSession(*script, *patient, "insonate test", file, {}, pictures);
    if (!outcome) throw std::runtime_error(outcome.error().message);
    return std::move(*outcome);
  }
  static const AttemptEvent* seenIn(const SessionOutcome& outcome) {
    const auto seen = std::ranges::find(outcome.events, AttemptEventKind::BubblesSeen, &AttemptEvent::kind);
    return seen == outcome.events.end() ? nullptr : &*seen;
  }

  std::shared_ptr<const PatientCase> patient;
  const test::TemporaryFolder folder;
  std::filesystem::path file;
  Images images;

 private:
  int runs_ = 0;
};

TEST_F(BubblesInASession, ProveTheVeinInWhichTheImageShowsThem) {
  const SessionOutcome outcome = flush(0);
  const AttemptEvent* seen = seenIn(outcome);
  ASSERT_TRUE(seen);
  EXPECT_EQ(seen->wall, kVein);
  EXPECT_EQ(seen->vessel, 1);
  EXPECT_NEAR(seen->tip_mm.z, 0, 0.1);
}

TEST_F(BubblesInASession, AreNotSeenIfTheImageDoesNotShowTheVesselDownstream) {
  EXPECT_FALSE(seenIn(flush(0, R"({"move_probe_mm": [0, -11, 0], "speed_mmps": 200}, )"))) << "upstream of the tip";
  EXPECT_FALSE(seenIn(flush(0, R"({"move_probe_mm": [25, 0, 0], "speed_mmps": 200}, )"))) << "beside the vein";
}

TEST_F(BubblesInASession, InTheArteryTheyProveNothing) {
  const SessionOutcome outcome =
      flush(-15, R"({"move_probe_mm": [0, -9, 0], "speed_mmps": 200}, )", "flush for bubbles", 19);
  const AttemptEvent* seen = seenIn(outcome);
  ASSERT_TRUE(seen);
  EXPECT_EQ(seen->wall, kArtery);
  EXPECT_NE(seen->vessel, 1);
}

/// Two seconds of images, forward and backward.
TEST_F(BubblesInASession, AReplayShowsTheSameBubblesBitForBit) {
  flush(0);
  const Images flushed = images;
  auto recording = AttemptRecording::open(file);
  ASSERT_TRUE(recording) << recording.error().message;
  auto replay = AttemptImages::make(std::make_shared<const AttemptRecording>(std::move(*recording)), patient);
  ASSERT_TRUE(replay) << replay.error().message;
  for (auto it = flushed.rbegin(); it != flushed.rend(); ++it)
    EXPECT_EQ((*replay->at(it->first))->image.gray, it->second);
  for (const auto& [time_us, gray] : flushed) EXPECT_EQ((*replay->at(time_us))->image.gray, gray);
  flush(0, "", "measure pressure");
  ASSERT_EQ(images.size(), flushed.size());
  int brighter = 0;
  const auto last = std::prev(flushed.end());
  for (std::size_t i = 0; i < last->second.size(); ++i) brighter += last->second[i] > images[last->first][i] + 60;
  EXPECT_GT(brighter, 100) << "bubbles are bright";
  EXPECT_EQ(images.begin()->second, flushed.begin()->second) << "before the flush";
}

}  // namespace
}  // namespace insonate
