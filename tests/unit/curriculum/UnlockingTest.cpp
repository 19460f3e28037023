#include "AttemptMaker.h"

#include <insonate/curriculum/Unlocking.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace insonate {
namespace {

using test::attemptsAt;
using test::courseOf;
using test::kDay_us;
using test::kNoon_us;
using test::levelNamed;
using testing::HasSubstr;

constexpr std::int64_t kHour_us = kDay_us / 24;

std::vector<AttemptFacts> joined(std::vector<AttemptFacts> first, const std::vector<AttemptFacts>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

/// "a" three times in a row opens "b".
Curriculum twoLevels() {
  return courseOf({levelNamed("a", 3), levelNamed("b", 1, {"a"})});
}

TEST(Unlocking, WithoutHistoryTheFirstLevelIsOpen) {
  const auto progress = computeProgress(twoLevels(), {}, kNoon_us);
  ASSERT_EQ(progress.size(), 2U);
  EXPECT_EQ(progress[0].state, LevelState::Open);
  EXPECT_EQ(progress[0].why, "Unlocked: no attempt counts yet; 3 passed attempts in a row master it.");
  EXPECT_EQ(progress[0].since_us, std::nullopt);
  EXPECT_EQ(progress[1].state, LevelState::Locked);
  EXPECT_EQ(progress[1].why, "Locked: master 'Level a' (0 of 3 passed attempts in a row) first.");
}

TEST(Unlocking, PassesInARowMasterAndOpenWhatComesNext) {
  auto progress = computeProgress(twoLevels(), attemptsAt("a", "PFPP"), kNoon_us);
  EXPECT_EQ(progress[0].state, LevelState::Open);
  EXPECT_EQ(progress[0].why, "Unlocked: 2 of 3 passed attempts in a row; the last attempt passed.");
  EXPECT_EQ(progress[0].attempts, 4);
  EXPECT_EQ(progress[0].passes, 3);
  EXPECT_EQ(progress[1].why, "Locked: master 'Level a' (2 of 3 passed attempts in a row) first.");
  progress = computeProgress(twoLevels(), attemptsAt("a", "PFPPP"), kNoon_us + kDay_us);
  EXPECT_EQ(progress[0].state, LevelState::Mastered);
  EXPECT_EQ(progress[0].why, "Mastered with 3 passed attempts in a row.");
  EXPECT_EQ(progress[0].since_us, kNoon_us + 4 * kHour_us);
  EXPECT_EQ(progress[1].state, LevelState::Open);
  EXPECT_EQ(progress[1].since_us, kNoon_us + 4 * kHour_us);
}

TEST(Unlocking, AFailureIsExplained) {
  Curriculum course = twoLevels();
  course.levels[0].pass.standards = {{"artery_punctures", 1, std::nullopt, 0, "the artery was punctured", ""}};
  auto history = attemptsAt("a", "PP");
  history[0].metrics = {{"artery_punctures", 1, 0}};
  history[1].metrics = {{"artery_punctures", 1, 1}};
  history[1].criticalErrors = 1;
  const auto progress = computeProgress(course, history, kNoon_us);
  EXPECT_EQ(progress[0].why,
            "Unlocked: 0 of 3 passed attempts in a row; the last attempt failed because there was a critical error; "
            "the artery was "
            "punctured (1, at most 0).");
  EXPECT_EQ(progress[0].summary, "Unlocked: 0 of 3 passed attempts in a row.");
  EXPECT_EQ(progress[0].standardsMet, 0);
  EXPECT_FALSE(progress[0].lastPassed);
}

TEST(Unlocking, WhatDoesNotCountIsPassedOver) {
  auto history = attemptsAt("a", "PPFPPP");
  history[2].state = AttemptState::Voided;
  history[3].state = AttemptState::Open;
  history[4].procedure = "another";
  history[5].curriculum = "another";
  history.push_back(test::failedAttempt("a"));
  history.back().state = AttemptState::Abandoned;
  history.back().metrics = {{"passes", 1, 0}};  // before the skin
  const auto progress = computeProgress(twoLevels(), history, kNoon_us + kDay_us);
  EXPECT_EQ(progress[0].attempts, 2);
  EXPECT_EQ(progress[0].consecutivePasses, 2);
  history.back().metrics = {{"passes", 1, 1}};  // with the needle in the skin
  EXPECT_EQ(computeProgress(twoLevels(), history, kNoon_us + kDay_us)[0].consecutivePasses, 0);
}

TEST(Unlocking, ARecordingThatBreaksOffBreaksTheRowUnlessItIsVoided) {
  auto history = attemptsAt("a", "PPF");
  history.back().state = AttemptState::Abandoned;
  const auto broken = computeProgress(twoLevels(), history, kNoon_us + kDay_us)[0];
  EXPECT_EQ(broken.attempts, 3);
  EXPECT_EQ(broken.consecutivePasses, 0);
  EXPECT_EQ(broken.why,
            "Unlocked: 0 of 3 passed attempts in a row; the last attempt failed because it was abandoned: its "
            "recording broke off.");
  history.back().state = AttemptState::Voided;
  EXPECT_EQ(computeProgress(twoLevels(), history, kNoon_us + kDay_us)[0].consecutivePasses, 2);
}

TEST(Unlocking, AttemptsOfAnotherVersionCountByTheRulesOfThisOne) {
  auto history = attemptsAt("a", "PPP");
  for (AttemptFacts& attempt : history) attempt.curriculumVersion = 7;
  EXPECT_EQ(computeProgress(twoLevels(), history, kNoon_us + kDay_us)[0].state, LevelState::Mastered);
}

TEST(Unlocking, PassesMadeWhileLockedCountOnceItOpens) {
  auto progress = computeProgress(twoLevels(), attemptsAt("b", "P"), kNoon_us + kDay_us);
  EXPECT_EQ(progress[1].state, LevelState::Locked);
  EXPECT_EQ(progress[1].why,
            "Locked: master 'Level a' (0 of 3 passed attempts in a row) first; one passed attempt made here will count "
            "then.");
  progress = computeProgress(twoLevels(), joined(attemptsAt("b", "P"), attemptsAt("a", "PPP", kNoon_us + kDay_us)),
                             kNoon_us + 2 * kDay_us);
  EXPECT_EQ(progress[1].state, LevelState::Mastered);
  EXPECT_EQ(progress[1].since_us, kNoon_us + kDay_us + 2 * kHour_us);
}

TEST(Unlocking, LcCusumIsWaitedForAndRemembered) {
  Curriculum course = courseOf({levelNamed("a", 2)});
  course.levels[0].mastery.cusum = CusumRule{0.10, 0.25, 0.5};  // 0.182 a pass: three reach 0.547
  auto progress = computeProgress(course, attemptsAt("a", "PP"), kNoon_us);
  EXPECT_EQ(
      progress[0].why,
      "Unlocked: 2 passed attempts in a row; the learning score (LC-CUSUM) is 0.36 of 0.50; the last attempt passed.");
  ASSERT_EQ(progress[0].cusum.size(), 2U);
  EXPECT_NEAR(progress[0].cusum[1], 0.365, 0.001);
  progress = computeProgress(course, attemptsAt("a", "PPP"), kNoon_us);
  EXPECT_EQ(progress[0].state, LevelState::Mastered);
  EXPECT_EQ(progress[0].why,
            "Mastered with 2 passed attempts in a row; the learning score (LC-CUSUM) has reached 0.50.");
  // Signalled, then the row was broken before it was long enough: no second signal is needed.
  course.levels[0].mastery.consecutivePasses = 4;
  progress = computeProgress(course, attemptsAt("a", "PPPFPPPP"), kNoon_us);
  EXPECT_TRUE(progress[0].cusumSignaled);
  EXPECT_EQ(progress[0].state, LevelState::Mastered);
}

TEST(Unlocking, ASkillLapsesAfterDaysWithoutPracticeAndIsRenewed) {
  Curriculum course = courseOf({levelNamed("a", 2), levelNamed("b", 1, {"a"})});
  course.levels[0].mastery.lapsesAfter_days = 90;
  const auto history = attemptsAt("a", "PP");
  const std::int64_t last_us = history.back().begun_us;
  auto progress = computeProgress(course, history, last_us + 80 * kDay_us);
  EXPECT_EQ(progress[0].why,
            "Mastered with 2 passed attempts in a row; it lapses after 90 days without practice, 10 days from now.");
  progress = computeProgress(course, history, last_us + 90 * kDay_us);
  EXPECT_EQ(progress[0].state, LevelState::Mastered);
  progress = computeProgress(course, history, last_us + 95 * kDay_us);
  EXPECT_EQ(progress[0].state, LevelState::Lapsed);
  EXPECT_EQ(progress[0].since_us, last_us + 90 * kDay_us);
  EXPECT_EQ(progress[0].why,
            "Lapsed: more than 90 days without practice (95 days); 2 passed attempts in a row renew it.");
  EXPECT_EQ(progress[1].state, LevelState::Locked);
  EXPECT_EQ(progress[1].why, "Locked: renew 'Level a' first, which lapsed.");
  const auto once = joined(history, attemptsAt("a", "P", last_us + 95 * kDay_us));
  progress = computeProgress(course, once, last_us + 96 * kDay_us);
  EXPECT_EQ(progress[0].why,
            "Lapsed: more than 90 days without practice; 2 passed attempts in a row renew it, 1 so far.");
  const auto twice = joined(history, attemptsAt("a", "PP", last_us + 95 * kDay_us));
  progress = computeProgress(course, twice, last_us + 96 * kDay_us);
  EXPECT_EQ(progress[0].state, LevelState::Mastered);
  EXPECT_EQ(progress[1].state, LevelState::Open);
}

TEST(Unlocking, PractisingWhatBuildsOnALevelKeepsIt) {
  Curriculum course = courseOf({levelNamed("a", 1), levelNamed("b", 5, {"a"}), levelNamed("c", 5, {"b"})});
  course.levels[0].mastery.lapsesAfter_days = 30;
  const auto history = joined(attemptsAt("a", "P"), attemptsAt("c", "F", kNoon_us + 20 * kDay_us));
  EXPECT_EQ(computeProgress(course, history, kNoon_us + 45 * kDay_us)[0].state, LevelState::Mastered);
  EXPECT_EQ(computeProgress(course, history, kNoon_us + 55 * kDay_us)[0].state, LevelState::Lapsed);
}

TEST(Unlocking, ASkillLapsesByFailuresSinceMastery) {
  Curriculum course = courseOf({levelNamed("a", 2)});
  course.levels[0].mastery.lapsesAfter = FailureRule{2, 3};
  EXPECT_EQ(computeProgress(course, attemptsAt("a", "FFPP"), kNoon_us)[0].state, LevelState::Mastered);
  auto progress = computeProgress(course, attemptsAt("a", "FFPPF"), kNoon_us);
  EXPECT_EQ(progress[0].state, LevelState::Mastered);
  EXPECT_EQ(progress[0].why,
            "Mastered with 2 passed attempts in a row; the last attempt failed because it did not succeed; 2 failures "
            "within 3 "
            "attempts let it lapse, 1 so far.");
  EXPECT_EQ(computeProgress(course, attemptsAt("a", "PPFPPF"), kNoon_us)[0].state, LevelState::Mastered);
  progress = computeProgress(course, attemptsAt("a", "PPFPF"), kNoon_us);
  EXPECT_EQ(progress[0].state, LevelState::Lapsed);
  EXPECT_EQ(progress[0].why,
            "Lapsed: 2 failures within 3 attempts; 2 passed attempts in a row renew it; the last attempt failed "
            "because it did "
            "not succeed.");
  EXPECT_EQ(computeProgress(course, attemptsAt("a", "PPFPFPP"), kNoon_us)[0].state, LevelState::Mastered);
}

TEST(Unlocking, WhatWasMasteredStaysSoWhileAPrerequisiteLapses) {
  Curriculum course = courseOf({levelNamed("a", 1), levelNamed("b", 1, {"a"}), levelNamed("c", 1, {"b"})});
  course.levels[0].mastery.lapsesAfter = FailureRule{1, 1};
  const auto progress = computeProgress(
      course, joined(joined(attemptsAt("a", "P"), attemptsAt("b", "P")), attemptsAt("a", "F")), kNoon_us);
  EXPECT_EQ(progress[0].state, LevelState::Lapsed);
  EXPECT_EQ(progress[1].state, LevelState::Mastered);
  EXPECT_EQ(progress[2].state, LevelState::Open);
}

/// State of a level with 2 consecutive passes and a lapse by 2 failures of 3, computed from the beginning.
LevelState plainReading(const std::string& outcomes) {
  LevelState state = LevelState::Open;
  std::size_t from = 0;  // where what counts for the next change begins
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const std::string since = outcomes.substr(from, i + 1 - from);
    const std::string last = since.substr(since.size() - std::min<std::size_t>(since.size(), 3));
    const bool mastered = state == LevelState::Mastered;
    if (mastered ? std::ranges::count(last, 'F') < 2 : !since.ends_with("PP")) continue;
    state = mastered ? LevelState::Lapsed : LevelState::Mastered;
    from = i + 1;
  }
  return state;
}

TEST(Unlocking, AnyHistoryAgreesWithItsPlainReading) {
  Curriculum course = courseOf({levelNamed("a", 2)});
  course.levels[0].mastery.lapsesAfter = FailureRule{2, 3};
  for (int bits = 0; bits < 1 << 10; ++bits)
    for (int length = 0; length <= 10; ++length) {
      std::string outcomes;
      for (int i = 0; i < length; ++i) outcomes += bits >> i & 1 ? 'P' : 'F';
      ASSERT_EQ(computeProgress(course, attemptsAt("a", outcomes), kNoon_us)[0].state, plainReading(outcomes))
          << outcomes;
    }
}

TEST(Unlocking, MissingAndLapsedPrerequisitesAreBothNamed) {
  Curriculum course = courseOf({levelNamed("a", 1), levelNamed("b", 1), levelNamed("c", 1), levelNamed("d", 1)});
  course.levels[3].prerequisites = {"a", "b", "c"};
  course.levels[0].mastery.lapsesAfter_days = 1;
  const auto progress = computeProgress(course, attemptsAt("a", "P"), kNoon_us + 9 * kDay_us);
  EXPECT_EQ(progress[3].why, "Locked: master 'Level b', 'Level c' first; renew 'Level a' first, which lapsed.");
}

TEST(Unlocking, ClocksThatJumpNeitherLapseNorSave) {
  Curriculum course = courseOf({levelNamed("a", 1)});
  course.levels[0].mastery.lapsesAfter_days = 30;
  const std::int64_t now_us = kNoon_us + 10 * kDay_us;
  // Back to 1970 after a good time: practice is as late as what came before it.
  auto history = joined(attemptsAt("a", "P"), attemptsAt("a", "P", 1));
  EXPECT_EQ(computeProgress(course, history, now_us)[0].state, LevelState::Mastered);
  // Ahead to 2126: not believed, so that it does not keep the skill for a century.
  history = joined(attemptsAt("a", "P"), attemptsAt("a", "P", kNoon_us + 36'500 * kDay_us));
  EXPECT_EQ(computeProgress(course, history, now_us)[0].state, LevelState::Mastered);
  EXPECT_EQ(computeProgress(course, history, kNoon_us + 40 * kDay_us)[0].state, LevelState::Lapsed);
  // Nothing but times that cannot be: taken as now.
  history = attemptsAt("a", "P", INT64_MAX - kDay_us);
  EXPECT_EQ(computeProgress(course, history, now_us)[0].state, LevelState::Mastered);
  history = attemptsAt("a", "P", INT64_MIN);
  EXPECT_EQ(computeProgress(course, history, now_us)[0].state, LevelState::Mastered);
}

TEST(Unlocking, ALevelSaysHowManyAttemptsItTakesAtLeast) {
  Curriculum course = courseOf({levelNamed("a", 3)});
  EXPECT_EQ(fewestAttempts(course.levels[0].mastery), 3);
  course.levels[0].mastery.cusum = CusumRule{0.1, 0.4, 4.07};
  EXPECT_EQ(fewestAttempts(course.levels[0].mastery), 11);
  EXPECT_EQ(computeProgress(course, {}, kNoon_us)[0].why,
            "Unlocked: no attempt counts yet; 3 passed attempts in a row master it, with a learning score (LC-CUSUM) "
            "of 4.07: at "
            "least 11 attempts.");
  EXPECT_EQ(computeProgress(course, attemptsAt("a", "PPPPPPPPPP"), kNoon_us + kDay_us)[0].state, LevelState::Open);
  EXPECT_EQ(computeProgress(course, attemptsAt("a", "PPPPPPPPPPP"), kNoon_us + kDay_us)[0].state, LevelState::Mastered);
  course.levels[0].mastery.cusum->limit = 0.4;
  EXPECT_EQ(fewestAttempts(course.levels[0].mastery), 3) << "the row takes longer";
}

}  // namespace
}  // namespace insonate
