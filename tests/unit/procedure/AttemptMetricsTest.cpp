#include "unit/procedure/ScriptedAttempt.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace insonate {
namespace {

using test::ScriptedAttempt;

/// A value to within a tick's time or way.
auto is(double value) {
  return testing::Optional(testing::DoubleNear(value, 0.011));
}
const auto kMissing = testing::Eq(std::nullopt);

/// From 5 mm above the skin to 25 mm deep at 10 mm/s, the vein between 20 and 30.
TEST(Attempt, CleanSuccess) {
  ScriptedAttempt attempt;
  attempt.toVeinCenter_mm = 1.5, attempt.toArtery_mm = 6;
  attempt.aspirating = true;
  attempt.hold(1);
  attempt.needleTo(25);
  attempt.hold(1);
  const MetricValues values = attempt.values();
  EXPECT_EQ(values[Metric::VeinPunctures], 1);
  EXPECT_EQ(values[Metric::ArteryPunctures], 0);
  EXPECT_EQ(values[Metric::PosteriorWallPunctures], 0);
  EXPECT_THAT(values[Metric::TimeToVein], is(2));
  EXPECT_EQ(values[Metric::UsedNeedleInsertions], 0);
  EXPECT_THAT(values[Metric::TimeToAccess], is(2));
  EXPECT_THAT(values[Metric::AttemptTime], is(5));
  EXPECT_EQ(values[Metric::Passes], 1);
  EXPECT_EQ(values[Metric::Redirections], 0);
  EXPECT_THAT(values[Metric::NeedlePath], is(20));
  EXPECT_THAT(values[Metric::NeedleInefficiency], is(0));
  EXPECT_THAT(values[Metric::PathDeviation], is(0));
  EXPECT_THAT(values[Metric::InsertionAngle], is(45));
  EXPECT_THAT(values[Metric::AspirationWhileAdvancing], is(100));
  EXPECT_EQ(values[Metric::VeinCenterDistance], 1.5);
  EXPECT_EQ(values[Metric::TipInVein], 1);
  EXPECT_EQ(values[Metric::NearestArtery], 6);
  EXPECT_EQ(values[Metric::NearestLung], std::nullopt);
  EXPECT_THAT(values[Metric::ProbePath], is(0));
  EXPECT_EQ(values[Metric::ProbeTranslations], 0);
  EXPECT_EQ(values[Metric::ProbeForceMean], 2);
}

/// The face is 38 mm wide over x = 20, so the image begins at x = 1, where the needle is 1.414 mm in. From the skin to
/// the vein at 20 mm it takes 2 s: 92.93 % of that time the image shows the tip.
TEST(Attempt, TipInPictureIsAShareOfTheTimeUnderTheSkin) {
  ScriptedAttempt attempt;
  attempt.needleTo(25);
  EXPECT_NEAR(*attempt.values()[Metric::TipInImage], 92.93, 0.1);
  ScriptedAttempt half;
  half.needleTo(10);
  half.probe_y_mm = 3.1;
  half.needleTo(25);
  EXPECT_NEAR(*half.values()[Metric::TipInImage], 42.93, 0.1) << "further off the plane than the slice is thick, 3 mm";
  ScriptedAttempt near;
  near.probe_y_mm = 2.9;
  near.needleTo(25);
  EXPECT_NEAR(*near.values()[Metric::TipInImage], 92.93, 0.1) << "off the plane, still as bright as speckle";
}

/// 1 s to 10 mm with the image, 1 s held still without it, 1 s on to the vein with it; held frozen it does not count.
TEST(Attempt, TipInPictureCountsWaitingAndNotFreezing) {
  ScriptedAttempt attempt;
  attempt.needleTo(10);
  attempt.probeHeld = false, attempt.hold(1), attempt.probeHeld = true;
  attempt.tell(AttemptEventKind::Frozen), attempt.hold(5), attempt.tell(AttemptEventKind::Released);
  attempt.needleTo(25);
  EXPECT_NEAR(*attempt.values()[Metric::TipInImage], 100 * (2 - 0.1414) / 3, 0.1);
  attempt.hold(10);
  EXPECT_NEAR(*attempt.values()[Metric::TipInImage], 100 * (2 - 0.1414) / 3, 0.1) << "after access nothing counts";
}

TEST(Attempt, NeedleNeverInTheImage) {
  ScriptedAttempt attempt;
  attempt.probe_y_mm = 10;
  attempt.needleTo(25);
  EXPECT_EQ(attempt.values()[Metric::TipInImage], 0);
}

TEST(Attempt, ProbeLifted) {
  ScriptedAttempt attempt;
  attempt.probeHeld = false;
  attempt.needleTo(25);
  const MetricValues values = attempt.values();
  EXPECT_EQ(values[Metric::TipInImage], 0) << "nothing was seen";
  EXPECT_THAT(values[Metric::ProbePath], kMissing);
  EXPECT_THAT(values[Metric::ProbeTranslations], kMissing);
  EXPECT_THAT(values[Metric::ProbeForceMean], kMissing);
  EXPECT_THAT(values[Metric::VeinCenterDistance], kMissing);
}

TEST(Attempt, PosteriorWall) {
  ScriptedAttempt attempt;
  attempt.needleTo(35);
  EXPECT_EQ(attempt.values()[Metric::TipInVein], 0);
  attempt.needleTo(25);
  const MetricValues values = attempt.values();
  EXPECT_EQ(values[Metric::VeinPunctures], 1);
  EXPECT_EQ(values[Metric::PosteriorWallPunctures], 1);
  EXPECT_EQ(values[Metric::TipInVein], 1) << "drawn back into the vein";
  EXPECT_THAT(values[Metric::TimeToVein], is(2));
}

TEST(Attempt, BloodThatIsDrawnInPassingIsNoTipInTheVein) {
  ScriptedAttempt attempt;
  attempt.walls = {{kVein, 20, 45}};
  attempt.aspirating = true;
  attempt.needleTo(50), attempt.needleTo(-5);
  EXPECT_EQ(attempt.values()[Metric::TipInVein], 0) << "2.5 s of it, on the way back";
  attempt.needleTo(50), attempt.needleTo(30), attempt.hold(1.1), attempt.needleTo(-5);
  EXPECT_EQ(attempt.values()[Metric::TipInVein], 1) << "it stood there, drawn back through the back wall";
}

TEST(Attempt, DrawnOutAfterBloodWasDrawn) {
  ScriptedAttempt attempt;
  attempt.needleTo(25), attempt.needleTo(-5);
  EXPECT_EQ(attempt.values()[Metric::TipInVein], 0) << "nobody drew";
  attempt.needleTo(25);
  attempt.aspirating = true;
  attempt.hold(0.4), attempt.needleTo(-5);
  EXPECT_EQ(attempt.values()[Metric::TipInVein], 0) << "0.4 s, and 0.5 s on the way back: not a second";
  attempt.needleTo(25), attempt.hold(1.1), attempt.needleTo(-5);
  EXPECT_EQ(attempt.values()[Metric::TipInVein], 1);
  attempt.needleTo(5);
  EXPECT_EQ(attempt.values()[Metric::TipInVein], 0) << "a new pass";
  attempt.needleTo(25), attempt.hold(1.1), attempt.needleTo(35), attempt.needleTo(-5);
  EXPECT_EQ(attempt.values()[Metric::TipInVein], 0) << "through the back wall before";
}

TEST(Attempt, Carotid) {
  ScriptedAttempt attempt;
  attempt.walls = {{kArtery, 22, 28}};
  attempt.needleTo(25);
  const MetricValues values = attempt.values();
  EXPECT_EQ(values[Metric::ArteryPunctures], 1);
  EXPECT_EQ(values[Metric::VeinPunctures], 0);
  EXPECT_THAT(values[Metric::TimeToVein], kMissing);
  EXPECT_THAT(values[Metric::NeedleInefficiency], kMissing);
  EXPECT_THAT(values[Metric::PathDeviation], kMissing);
  EXPECT_NEAR(*values[Metric::NeedlePath], 24.75, 0.26) << "whole steps of half a millimetre";
}

/// The first pass misses; 5 mm aside the second meets the vein. 12 mm down and up, then 20 mm: 44 mm for 20, less up to
/// a millimeter where the steps turn.
TEST(Attempt, TwoPassesWithANewNeedle) {
  ScriptedAttempt attempt;
  attempt.walls.clear();
  attempt.needleTo(12);
  attempt.needleTo(-5);
  attempt.tell(AttemptEventKind::NeedleReplaced);
  attempt.aim(5);
  attempt.walls = {{kVein, 20, 30}};
  attempt.needleTo(25);
  const MetricValues values = attempt.values();
  EXPECT_EQ(values[Metric::Passes], 2);
  EXPECT_EQ(values[Metric::UsedNeedleInsertions], 0);
  EXPECT_THAT(values[Metric::TimeToVein], is(2)) << "within the pass";
  // 1.2 s down, 1.2 up, 0.5 above the skin and 0.5 back to it, 2 to the vein.
  EXPECT_THAT(values[Metric::TimeToAccess], is(5.4));
  EXPECT_NEAR(*values[Metric::NeedlePath], 43.5, 0.52);
  EXPECT_NEAR(*values[Metric::NeedleInefficiency], 100 * (*values[Metric::NeedlePath] / 20 - 1), 0.1);
  EXPECT_EQ(values[Metric::Redirections], 0) << "out of the skin is a pass, not a redirection";
}

TEST(Attempt, UsedNeedle) {
  ScriptedAttempt attempt;
  attempt.needleTo(12), attempt.needleTo(-5), attempt.needleTo(12), attempt.needleTo(-5);
  EXPECT_EQ(attempt.values()[Metric::UsedNeedleInsertions], 1);
  attempt.tell(AttemptEventKind::NeedleReplaced);
  attempt.needleTo(12), attempt.needleTo(-5), attempt.needleTo(12);
  EXPECT_EQ(attempt.values()[Metric::UsedNeedleInsertions], 2);
  EXPECT_EQ(attempt.values()[Metric::Passes], 4);
}

/// Trembling in the skin's hole is neither a pass nor a use of a used needle, and keeps d1.
TEST(Attempt, OutByAMillimetreIsTheSamePass) {
  ScriptedAttempt attempt;
  attempt.needleTo(25);
  for (int i = 0; i < 5; ++i) attempt.needleTo(-1), attempt.needleTo(5);
  const MetricValues values = attempt.values();
  EXPECT_EQ(values[Metric::Passes], 1);
  EXPECT_EQ(values[Metric::UsedNeedleInsertions], 0);
  attempt.needleTo(-2.5), attempt.needleTo(5);
  EXPECT_EQ(attempt.values()[Metric::Passes], 2);
}

TEST(Attempt, AbandonedBeforeTheSkin) {
  ScriptedAttempt attempt;
  attempt.hold(3);
  const MetricValues values = attempt.values();
  EXPECT_EQ(values[Metric::Passes], 0);
  EXPECT_EQ(values[Metric::VeinPunctures], 0);
  for (const Metric missing :
       {Metric::TimeToVein, Metric::TimeToAccess, Metric::NeedlePath, Metric::InsertionAngle, Metric::TipInImage,
        Metric::AspirationWhileAdvancing, Metric::TipInVein, Metric::ProbePath, Metric::NearestArtery})
    EXPECT_THAT(values[missing], kMissing) << metricTable()[static_cast<int>(missing)].id;
}

TEST(Attempt, Bone) {
  ScriptedAttempt attempt;
  attempt.walls = {{kBone, 15, 1e9}};
  attempt.needleTo(15);
  attempt.tell(AttemptEventKind::Struck, kBone);  // told again while it rests there
  EXPECT_EQ(attempt.values()[Metric::BoneContacts], 1);
  attempt.needleTo(12), attempt.needleTo(15);
  EXPECT_EQ(attempt.values()[Metric::BoneContacts], 2);
}

TEST(Attempt, Pneumothorax) {
  ScriptedAttempt attempt;
  attempt.walls = {{kVein, 20, 30}, {kAirway, 33, 60}};
  attempt.needleTo(40);
  const MetricValues values = attempt.values();
  EXPECT_EQ(values[Metric::LungPunctures], 1);
  EXPECT_EQ(values[Metric::PosteriorWallPunctures], 1);
}

TEST(Attempt, ValuesWithoutSamplesAreMissingOrNothing) {
  const MetricValues values = AttemptMetrics({}).values();
  EXPECT_EQ(values[Metric::Passes], 0);
  EXPECT_THAT(values[Metric::AttemptTime], kMissing);
}

/// A fan of 60 degrees about an apex 60 mm behind the face: at 10 mm of depth it is 70 sin 30 = 35 mm wide to each
/// side.
TEST(Attempt, FanShowsWhatItReaches) {
  const auto seenAt = [](double x_mm) {
    AttemptMetrics metrics({.fanAngle_deg = 60, .faceRadius_mm = 60, .sliceHalf_mm = 1});
    metrics.add(AttemptEvent{.kind = AttemptEventKind::Entered, .tip_mm = {x_mm, 0, 0}});
    for (const std::int64_t time_us : {1, 2})
      metrics.add(AttemptSample{.time_us = time_us,
                                .patientFromProbe = Transform{},
                                .patientFromNeedle = Transform{{}, {x_mm, 0, 0.62}},
                                .needleDepth_mm = 0.62,
                                .imageDepth_mm = 40});
    return metrics.values()[Metric::TipInImage];
  };
  // 0.62 mm below the face's plane: the fan's edge is at (60 + 0.62) tan 30 = 35.0 mm, where the face has curved away
  // by 60 (1 / cos 30 - 1) = 9.3 mm, so that only what is farther than 60 mm from the apex is seen.
  EXPECT_EQ(seenAt(0), 100);
  EXPECT_EQ(seenAt(34.9), 100);
  EXPECT_EQ(seenAt(35.1), 0);
}

TEST(MetricTable, IsInOrderAndSaysEverything) {
  std::set<std::string_view> ids;
  for (int i = 0; i < kMetricCount; ++i) {
    const MetricDefinition& entry = metricTable()[i];
    EXPECT_EQ(static_cast<int>(entry.metric), i) << entry.id;
    EXPECT_TRUE(ids.insert(entry.id).second) << entry.id;
    EXPECT_GE(entry.version, 1);
    EXPECT_FALSE(entry.definition.empty() || entry.evidence.empty()) << entry.id;
    if (!entry.unit.empty()) {
      const std::string_view suffix = entry.unit == "%" ? "percent" : entry.unit;
      EXPECT_TRUE(entry.id.ends_with(suffix)) << entry.id << " carries its unit, " << entry.unit;
    }
  }
  for (const char* thesis :
       {"vein_punctures", "artery_punctures", "double_punctures", "time_to_vein_s", "used_needle_insertions"})
    EXPECT_TRUE(ids.contains(thesis)) << thesis;
}

}  // namespace
}  // namespace insonate
