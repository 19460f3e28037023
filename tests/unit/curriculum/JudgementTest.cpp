#include "AttemptMaker.h"

#include <insonate/curriculum/Judgement.h>
#include <insonate/curriculum/Unlocking.h>

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

namespace insonate {
namespace {

using test::courseOf;
using test::failedAttempt;
using test::kNoon_us;
using test::levelNamed;
using test::passedAttempt;

MetricStandard atMost(const std::string& metric, double most, const std::string& otherwise) {
  return {metric, 1, std::nullopt, most, otherwise, ""};
}

AttemptFacts withMetric(AttemptFacts attempt, const std::string& metric, std::optional<double> value, int version = 1) {
  attempt.metrics.push_back({metric, version, value});
  return attempt;
}

TEST(Judgement, AnAttemptWithoutRulesPassesBySucceeding) {
  EXPECT_TRUE(judge({}, passedAttempt("a")).passed);
  EXPECT_EQ(judge({}, passedAttempt("a")).percentMet(), 100);
  EXPECT_FALSE(judge({}, failedAttempt("a")).passed);
  AttemptFacts critical = passedAttempt("a");
  critical.criticalErrors = 1;
  EXPECT_FALSE(judge({}, critical).passed);
  AttemptFacts abandoned = passedAttempt("a");
  abandoned.state = AttemptState::Abandoned;
  EXPECT_FALSE(judge({}, abandoned).passed);
}

TEST(Judgement, AMissingOrOtherValueDoesNotMeetAStandard) {
  const PassRule rule{std::nullopt, {atMost("passes", 2, "too many")}, 100};
  EXPECT_TRUE(judge(rule, withMetric(passedAttempt("a"), "passes", 2)).passed);
  EXPECT_FALSE(judge(rule, withMetric(passedAttempt("a"), "passes", 3)).passed);
  EXPECT_FALSE(judge(rule, passedAttempt("a")).passed);
  EXPECT_FALSE(judge(rule, withMetric(passedAttempt("a"), "passes", std::nullopt)).passed);
  EXPECT_FALSE(judge(rule, withMetric(passedAttempt("a"), "passes", std::numeric_limits<double>::quiet_NaN())).passed);
  EXPECT_FALSE(judge(rule, withMetric(passedAttempt("a"), "passes", 1, 2)).passed);
  EXPECT_EQ(reasonOfFailure(rule, withMetric(passedAttempt("a"), "passes", std::numeric_limits<double>::quiet_NaN())),
            "no data for passes");
}

TEST(Judgement, MasteryPercentageLetsSomeStandardsBeMissed) {
  PassRule rule;
  for (int i = 0; i < 9; ++i) rule.standards.push_back(atMost("m" + std::to_string(i), 0, "m"));
  AttemptFacts attempt = passedAttempt("a");
  for (int i = 0; i < 8; ++i) attempt = withMetric(attempt, "m" + std::to_string(i), 0);
  rule.mastery_percent = 88;  // 8 of 9 are 88.9 %
  EXPECT_TRUE(judge(rule, attempt).passed);
  EXPECT_EQ(judge(rule, attempt).met, 8);
  rule.mastery_percent = 89;
  EXPECT_FALSE(judge(rule, attempt).passed);
}

/// Nine of ten standards are met: 90 % of the 88 % that are asked for. The one that is missed must be met.
TEST(Judgement, ACriticalStandardFailsWhateverTheShare) {
  PassRule rule;
  rule.mastery_percent = 88;
  AttemptFacts attempt = passedAttempt("a");
  for (int i = 0; i < 9; ++i) {
    rule.standards.push_back(atMost("m" + std::to_string(i), 0, "m"));
    attempt = withMetric(attempt, "m" + std::to_string(i), 0);
  }
  rule.standards.push_back(atMost("double_punctures", 0, "the posterior wall was punctured"));
  attempt = withMetric(attempt, "double_punctures", 1);
  EXPECT_TRUE(judge(rule, attempt).passed);
  EXPECT_EQ(missedStandards(rule, attempt), std::vector<std::string>{"the posterior wall was punctured (1, at most 0)"})
      << "it passes, and what it missed is named";
  rule.standards.back().critical = true;
  EXPECT_FALSE(judge(rule, attempt).passed);
  EXPECT_EQ(judge(rule, attempt).percentMet(), 90);
  EXPECT_EQ(reasonOfFailure(rule, attempt), "the posterior wall was punctured (1, at most 0; must be met)");
  attempt.metrics.back().value = 0;
  EXPECT_TRUE(judge(rule, attempt).passed);
  EXPECT_TRUE(missedStandards(rule, attempt).empty());
}

TEST(Judgement, ValuesHaveTheirUnitsAndNeverLookLikeALimitThatTheyMiss) {
  PassRule rule;
  rule.standards = {atMost("insertion_angle_deg", 60, "the insertion angle was too steep (degrees)")};
  const auto reason = [&](double value) {
    return reasonOfFailure(rule, withMetric(passedAttempt("a"), rule.standards[0].metric, value));
  };
  EXPECT_EQ(reason(69.8216), "the insertion angle was too steep (69.8°, at most 60°)");
  EXPECT_EQ(reason(60.012), "the insertion angle was too steep (60.012°, at most 60°)");
  rule.standards[0] = atMost("time_to_access_s", 149, "the time to access was too long (s)");
  EXPECT_EQ(reason(212.04), "the time to access was too long (212 s, at most 149 s)");
  EXPECT_EQ(reason(1234.4), "the time to access was too long (1234 s, at most 149 s)");
  EXPECT_EQ(reason(149.3), "the time to access was too long (149.3 s, at most 149 s)");
}

TEST(Judgement, MinPointsAreReachedByPointsThatAreThere) {
  const PassRule rule{60.0, {}, 100};
  AttemptFacts attempt = passedAttempt("a");
  EXPECT_EQ(reasonOfFailure(rule, attempt), "it had no points and 60 are needed");
  for (const double odd : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    attempt.points = odd;
    EXPECT_EQ(reasonOfFailure(rule, attempt), "it had no points and 60 are needed");
  }
  attempt.points = 59.5;
  EXPECT_EQ(reasonOfFailure(rule, attempt), "it had 59.5 points and 60 are needed");
  attempt.points = 60;
  EXPECT_EQ(reasonOfFailure(rule, attempt), "");
}

TEST(Judgement, TheReasonIsTheWorstOne) {
  const PassRule rule{std::nullopt,
                      {atMost("artery_punctures", 0, "the artery was punctured"), atMost("passes", 2, "many passes"),
                       atMost("used_needle_insertions", 0, "a used needle was put in again")},
                      100};
  AttemptFacts attempt = withMetric(withMetric(passedAttempt("a"), "artery_punctures", 1), "passes", 2);
  attempt = withMetric(attempt, "used_needle_insertions", 0);
  EXPECT_EQ(reasonOfFailure(rule, attempt), "the artery was punctured (1, at most 0)");
  attempt.criticalErrors = 1;
  EXPECT_EQ(reasonOfFailure(rule, attempt), "there was a critical error; the artery was punctured (1, at most 0)");
  attempt.metrics[1].value = 5;
  EXPECT_EQ(reasonOfFailure(rule, attempt),
            "there was a critical error; the artery was punctured (1, at most 0); many passes (5, at most 2)");
  attempt.criticalErrors = 2, attempt.metrics.clear();
  EXPECT_EQ(reasonOfFailure(rule, attempt),
            "there were 2 critical errors; no data for artery punctures; no data for passes; no data for used needle "
            "insertions");
  EXPECT_EQ(reasonOfFailure({}, failedAttempt("a")), "it did not succeed");
}

TEST(Judgement, WithoutAValueNoLimitIsCalledMissedTwice) {
  const PassRule rule{std::nullopt,
                      {{"insertion_angle_deg", 2, 30, std::nullopt, "too flat", "a test"},
                       {"insertion_angle_deg", 2, std::nullopt, 60, "too steep", "a test"}},
                      100};
  EXPECT_EQ(reasonOfFailure(rule, passedAttempt("a")), "no data for insertion angle");
}

TEST(Judgement, FiguresAreOfPuncturesAndOfProvenSuccesses) {
  const AttemptFacts proven = withMetric(passedAttempt("a"), "passes", 1);
  EXPECT_TRUE(isInFigures(proven));
  EXPECT_FALSE(isInFigures(withMetric(passedAttempt("a"), "passes", 0))) << "no puncture, no complication";
  AttemptFacts unproven = proven;
  unproven.proof = AttemptProof::Unproven;
  EXPECT_FALSE(isInFigures(unproven)) << "it may be another person's";
  EXPECT_TRUE(waitsForAcceptance(unproven));
  unproven.succeeded = false;
  EXPECT_TRUE(isInFigures(unproven)) << "a failure counts without proof";
  EXPECT_FALSE(waitsForAcceptance(unproven));
  AttemptFacts abandoned = proven;
  abandoned.state = AttemptState::Abandoned, abandoned.points = 50;
  EXPECT_EQ(pointsOf(abandoned), std::nullopt) << "points of what was not done";
}

TEST(Judgement, WhatWasNotTriedDoesNotCount) {
  AttemptFacts attempt = passedAttempt("a");
  EXPECT_TRUE(isCounted(attempt));
  attempt.state = AttemptState::Open;
  EXPECT_FALSE(isCounted(attempt));
  attempt.state = AttemptState::Voided;
  EXPECT_FALSE(isCounted(attempt));
  attempt.state = AttemptState::Abandoned;
  EXPECT_FALSE(isCounted(withMetric(attempt, "passes", 0)));
  EXPECT_TRUE(isCounted(withMetric(attempt, "passes", 1)));
  EXPECT_EQ(reasonOfFailure({}, withMetric(attempt, "passes", 1)), "it was abandoned with the needle in the skin");
}

TEST(Judgement, APassCountsAtALevelOnceSomethingVouchesForIt) {
  Level level = levelNamed("a", 1);
  level.pass = {std::nullopt, {atMost("passes", 1, "there were too many passes")}, 100};
  AttemptFacts attempt = passedAttempt("a");
  for (const AttemptProof proof : {AttemptProof::Proven, AttemptProof::Accepted, AttemptProof::Earlier}) {
    attempt.proof = proof;
    EXPECT_TRUE(isCounted(withMetric(attempt, "passes", 1), level));
  }
  attempt.proof = AttemptProof::Unproven;
  EXPECT_TRUE(judge(level.pass, withMetric(attempt, "passes", 1)).passed);
  EXPECT_FALSE(isCounted(withMetric(attempt, "passes", 1), level));
  EXPECT_TRUE(isCounted(withMetric(attempt, "passes", 2), level)) << "as a failure";
  attempt.state = AttemptState::Abandoned;
  EXPECT_FALSE(isCounted(withMetric(attempt, "passes", 0), level)) << "before the skin";
}

TEST(Judgement, ATestThatWasNotOpenIsPractice) {
  Curriculum course = courseOf({levelNamed("a", 1)});
  Level& level = course.levels[0];
  AttemptFacts passed = passedAttempt("a"), failed = failedAttempt("a");
  const auto outcomes = [&](TestConditions testConditions) {
    passed.testConditions = failed.testConditions = testConditions;
    return outcomeWords(passed, &course) + "; " + outcomeWords(failed, &course);
  };
  using enum TestConditions;
  for (const TestConditions any : {None, Earlier, Opened, SelfAdministered, Practice, Undecided})
    EXPECT_EQ(outcomes(any), "Passed; Failed because it did not succeed") << "the level is no test";
  level.assistance = Assistance::Test;
  for (const TestConditions open : {Earlier, Opened, SelfAdministered}) {
    const std::string alone = open == SelfAdministered ? " (self-administered)" : "";
    EXPECT_EQ(outcomes(open), "Passed" + alone + "; Failed because it did not succeed" + alone);
    EXPECT_TRUE(isCounted(passed, level) && isCounted(failed, level));
  }
  for (const TestConditions closed : {None, Practice, Undecided}) {
    EXPECT_EQ(outcomes(closed),
              "Practice, the test was not open: would pass; Practice, the test was not open: would fail because it did "
              "not succeed");
    EXPECT_FALSE(isCounted(passed, level) || isCounted(failed, level));
    EXPECT_EQ(passedIn(course, failed), std::nullopt);
    EXPECT_EQ(computeProgress(course, std::vector{passed, failed}, kNoon_us)[0].attempts, 0);
  }
}

/// A crash, or a trainee who ends the program: nothing was measured.
TEST(Judgement, ARecordingThatBreaksOffCountsAsAbandoned) {
  AttemptFacts attempt = passedAttempt("a");
  attempt.state = AttemptState::Abandoned;
  const PassRule rule{std::nullopt, {atMost("artery_punctures", 0, "the artery was punctured")}, 100};
  EXPECT_TRUE(isCounted(attempt));
  EXPECT_FALSE(judge(rule, attempt).passed);
  EXPECT_EQ(reasonOfFailure(rule, attempt), "it was abandoned: its recording broke off");
  EXPECT_TRUE(isCounted(withMetric(attempt, "passes", std::nullopt)));
  attempt.state = AttemptState::Voided;
  EXPECT_FALSE(isCounted(attempt)) << "where an instructor voids it";
}

TEST(Judgement, OnlyWhatCountsAtALevelPassesOrFails) {
  const Curriculum course = test::courseOf({test::levelNamed("a", 1)});
  AttemptFacts attempt = passedAttempt("a");
  EXPECT_EQ(levelOf(course, attempt), &course.levels[0]);
  EXPECT_EQ(passedIn(course, attempt), true);
  attempt.curriculumVersion = 9;
  EXPECT_EQ(passedIn(course, attempt), true) << "of any version";
  attempt.succeeded = false;
  EXPECT_EQ(passedIn(course, attempt), false);
  attempt.state = AttemptState::Voided;
  EXPECT_EQ(passedIn(course, attempt), std::nullopt);
  attempt = passedAttempt("b");
  EXPECT_EQ(levelOf(course, attempt), nullptr);
  attempt = passedAttempt("a");
  attempt.procedure = "another";
  EXPECT_EQ(passedIn(course, attempt), std::nullopt);
  attempt = passedAttempt("a");
  attempt.curriculum = attempt.level = "";
  EXPECT_EQ(passedIn(course, attempt), std::nullopt) << "free practice";
}

}  // namespace
}  // namespace insonate
