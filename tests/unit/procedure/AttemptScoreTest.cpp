#include "unit/procedure/ScriptedAttempt.h"

#include <insonate/procedure/AttemptScore.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace insonate {
namespace {

using test::ScriptedAttempt;
using test::sentences;
using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Optional;

AttemptScore computeScore(const ScriptedAttempt& attempt, Procedure procedure) {
  ProcedureRun run(std::move(procedure), ScriptedAttempt::picture());
  for (const auto& entry : attempt.stream) std::visit([&](const auto& what) { run.add(what); }, entry);
  return insonate::computeScore(run);
}

AttemptScore computeScore(const ScriptedAttempt& attempt) {
  return computeScore(attempt, *loadProcedure("internal_jugular"));
}

const MetricScore& of(const AttemptScore& score, Metric metric) {
  return score.metrics.at(static_cast<std::size_t>(metric));
}

/// A vein reached within 2 s, blood drawn all the way.
ScriptedAttempt clean() {
  ScriptedAttempt attempt;
  attempt.aspirating = true;
  attempt.hold(2.1);
  attempt.needleTo(25);
  attempt.hold(1.1);
  return attempt;
}

/// Success, one rule of each severity, and norms of the time to access, 2 s in what follows, and of the back wall.
Procedure small() {
  return *parseProcedure(R"({"name": "p", "title": "P", "version": 1,
    "steps": [{"name": "vein", "title": "Puncture the vein", "say": "Go.",
               "until": {"happens": "entered", "wall": "vein"}}],
    "passBegins": "vein",
    "rules": [
      {"name": "artery", "metric": "artery_punctures", "over": 0, "severity": "critical", "say": "Artery.",
       "advice": "Mind the artery."},
      {"name": "back", "metric": "double_punctures", "over": 0, "severity": "major", "say": "Back wall.",
       "advice": "Go slowly."},
      {"name": "used", "metric": "used_needle_insertions", "over": 0, "severity": "minor", "say": "Take a new one."}],
    "success": [{"metric": "tip_in_vein", "over": 0}],
    "norms": [
      {"metric": "time_to_access_s", "novice": 6, "expert": 1, "source": "S", "advice": "Be quick."},
      {"metric": "double_punctures", "novice": 0.5, "expert": 0.1, "source": "S", "advice": "One wall."}]})");
}

TEST(AttemptScore, CleanAttemptHasAllPoints) {
  const AttemptScore score = computeScore(clean());
  EXPECT_EQ(score.points, 100);
  EXPECT_TRUE(score.succeeded);
  EXPECT_TRUE(score.criticalErrors.empty());
  EXPECT_EQ(score.advice, "No improvement is needed: repeat the attempt in the same way.");
  EXPECT_THAT(sentences(score), ElementsAre("The skin is punctured.", "The vein is reached."));
  EXPECT_EQ(score.moments[0].time_us, 2'600'000) << "2.1 s, and 5 mm at 10 mm/s";
  EXPECT_EQ(score.moments[1].time_us, 4'600'000);
  EXPECT_EQ(score.moments[1].severity, std::nullopt);
  ASSERT_EQ(score.metrics.size(), static_cast<std::size_t>(kMetricCount));
  EXPECT_EQ(of(score, Metric::TimeToAccess).norm->novice, 149);
  EXPECT_EQ(of(score, Metric::TimeToAccess).share, 100);
  EXPECT_EQ(of(score, Metric::Passes).value, 1);
  EXPECT_FALSE(of(score, Metric::Passes).norm) << "none is known";
  EXPECT_EQ(of(score, Metric::Passes).share, std::nullopt);
}

/// 100 (6 - 2) / (6 - 1) = 80 of the time, all of the back wall.
TEST(AttemptScore, MeanOfWhatLiesBetweenNoviceAndExpert) {
  const AttemptScore score = computeScore(clean(), small());
  EXPECT_THAT(of(score, Metric::TimeToAccess).share, Optional(DoubleNear(80, 0.1)));
  EXPECT_EQ(of(score, Metric::PosteriorWallPunctures).share, 100);
  EXPECT_THAT(score.points, Optional(DoubleNear(90, 0.1)));
  EXPECT_EQ(score.advice, "Be quick.");
}

/// A time of 2 s lies at 93 between 6 and 1.7 s, and at 83 between 6 and 1.2 s.
TEST(AttemptScore, ANearlyPerfectAttemptNeedsNoAdvice) {
  const auto adviceAt = [](double expert_s) {
    Procedure procedure = small();
    procedure.norms[0].expert = expert_s;
    return computeScore(clean(), procedure).advice;
  };
  EXPECT_EQ(adviceAt(1.7), "No improvement is needed: repeat the attempt in the same way.");
  EXPECT_EQ(adviceAt(1.2), "Be quick.");
}

/// Back wall: (80 + 0) / 2 - 20. Then out, and in again with the used needle: 5 more.
TEST(AttemptScore, FindingsCost) {
  ScriptedAttempt attempt;
  attempt.needleTo(35), attempt.needleTo(25);
  const AttemptScore back = computeScore(attempt, small());
  EXPECT_THAT(back.points, Optional(DoubleNear(20, 0.1)));
  EXPECT_EQ(back.advice, "Go slowly.");
  EXPECT_EQ(back.moments.back().severity, Severity::Major);
  attempt.needleTo(-5), attempt.needleTo(25);
  EXPECT_THAT(computeScore(attempt, small()).points, Optional(DoubleNear(15, 0.1)));
}

TEST(AttemptScore, MinorFindingIsAdvisedByItsSentenceWhereItHasNoAdvice) {
  ScriptedAttempt attempt;
  attempt.needleTo(25), attempt.needleTo(-5), attempt.needleTo(25);
  const AttemptScore score = computeScore(attempt, small());
  EXPECT_THAT(score.points, Optional(DoubleNear(85, 0.1)));
  EXPECT_EQ(score.advice, "Take a new one.");
}

TEST(AttemptScore, CriticalErrorVoids) {
  ScriptedAttempt attempt;
  attempt.walls = {{kArtery, 12, 18}, {kVein, 20, 30}};
  attempt.needleTo(35), attempt.needleTo(25);
  const AttemptScore score = computeScore(attempt, small());
  EXPECT_EQ(score.points, 0);
  EXPECT_TRUE(score.succeeded);
  ASSERT_EQ(score.criticalErrors.size(), 1u);
  EXPECT_EQ(score.criticalErrors[0].description, "Artery.");
  EXPECT_EQ(score.criticalErrors[0].time_us, 1'700'000);
  EXPECT_EQ(score.advice, "Mind the artery.") << "before the back wall";
}

/// 100 by the back wall alone, since the time to a vein that was not reached is missing.
TEST(AttemptScore, WithoutSuccessHalfAtMost) {
  ScriptedAttempt attempt;
  attempt.needleTo(15);
  const AttemptScore score = computeScore(attempt, small());
  EXPECT_EQ(of(score, Metric::TimeToAccess).share, std::nullopt);
  EXPECT_EQ(score.points, 50);
  EXPECT_EQ(score.advice, "The attempt ended before 'Puncture the vein' was done: practice that step next.");
}

TEST(AttemptScore, NothingToScore) {
  ScriptedAttempt attempt;
  EXPECT_EQ(computeScore(attempt).points, std::nullopt);
  attempt.hold(3);
  const AttemptScore score = computeScore(attempt);
  EXPECT_EQ(score.points, std::nullopt) << "the skin was not punctured";
  for (const MetricScore& metric : score.metrics)
    EXPECT_EQ(metric.share, std::nullopt) << "no artery was punctured, but not because of skill";
  EXPECT_TRUE(score.moments.empty());
  EXPECT_THAT(score.advice, HasSubstr("'Puncture the skin'"));
  Procedure plain = small();
  plain.norms.clear();
  EXPECT_EQ(computeScore(clean(), plain).points, std::nullopt) << "nothing is known to compare with";
}

/// Blood drawn, looked at, drawn out: the last step of the procedure takes nothing from the score.
TEST(AttemptScore, DrawnOutAfterBloodItIsStillASuccess) {
  ScriptedAttempt attempt = clean();
  attempt.tell(AttemptEventKind::Frozen), attempt.tell(AttemptEventKind::Released);
  attempt.needleTo(-5);
  const AttemptScore score = computeScore(attempt);
  EXPECT_TRUE(score.succeeded);
  EXPECT_EQ(score.points, 100);
  EXPECT_THAT(sentences(score), ElementsAre("The skin is punctured.", "The vein is reached.",
                                            "Image and needle are frozen.", "The needle is out of the skin."));
}

TEST(AttemptScore, MomentsTellEachThingOnce) {
  ScriptedAttempt attempt;
  attempt.tell(AttemptEventKind::Positioned);
  attempt.walls = {{kArtery, 12, 18}, {kBone, 25, 1e9}};
  attempt.needleTo(25);
  attempt.needleTo(-5);
  attempt.tell(AttemptEventKind::NeedleReplaced);
  const AttemptScore score = computeScore(attempt, small());
  EXPECT_THAT(sentences(score),
              ElementsAre("The patient lies flat.", "The skin is punctured.", "Artery.", "The needle meets bone.",
                          "The needle is out of the skin.", "A new needle is taken."));
  EXPECT_TRUE(std::ranges::is_sorted(score.moments, {}, &AttemptMoment::time_us));
}

/// A tip that trembles in the vein's hole has punctured it once.
TEST(AttemptScore, ATremblingTipIsOneMoment) {
  ScriptedAttempt attempt;
  attempt.needleTo(20.3);
  for (int i = 0; i < 5; ++i) attempt.needleTo(19.7), attempt.needleTo(20.3);
  EXPECT_THAT(sentences(computeScore(attempt)), ElementsAre("The skin is punctured.", "The vein is reached."));
}

}  // namespace
}  // namespace insonate
