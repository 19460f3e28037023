#include "AttemptMaker.h"

#include <insonate/curriculum/Judgement.h>
#include <insonate/curriculum/Unlocking.h>

#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <limits>
#include <random>

namespace insonate {
namespace {

using test::kDay_us;
using test::kNoon_us;

constexpr int kPeople = 200, kAttempts = 500;

/// Somebody's attempts at the preset's levels, one after the other, three of four of which pass.
std::vector<AttemptFacts> someHistory(const Curriculum& course, std::mt19937& random) {
  std::vector<AttemptFacts> history;
  for (int i = 0; i < kAttempts; ++i) {
    const Level& level = course.levels[static_cast<std::size_t>(i) * course.levels.size() / kAttempts];
    AttemptFacts attempt = test::passedAttempt(level.name, kNoon_us + i * kDay_us / 4);
    attempt.curriculum = course.name, attempt.procedure = level.procedure;
    attempt.succeeded = random() % 4 != 0;
    for (const MetricStandard& standard : level.pass.standards)
      if (!valueOf(attempt, standard.metric, standard.version))
        attempt.metrics.push_back(
            {standard.metric, standard.version, standard.minimum ? *standard.minimum : *standard.maximum});
    history.push_back(std::move(attempt));
  }
  return history;
}

TEST(HostileHistory, AClassOf200WithAHundredThousandAttempts) {
  const auto course = loadCurriculum("central_line");
  ASSERT_TRUE(course) << course.error().message;
  std::mt19937 random(1);
  std::vector<std::vector<AttemptFacts>> people;
  for (int i = 0; i < kPeople; ++i) people.push_back(someHistory(*course, random));
  const auto begin = std::chrono::steady_clock::now();
  int mastered = 0;
  for (const auto& history : people)
    for (const LevelProgress& level : computeProgress(*course, history, kNoon_us + 130 * kDay_us))
      mastered += level.state == LevelState::Mastered;
  const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
  EXPECT_GT(mastered, kPeople);
  std::printf("unlocking of %d people with %d attempts each: %.1f ms\n", kPeople, kAttempts, took.count());
  RecordProperty("class_ms", static_cast<int>(took.count()));
}

TEST(HostileHistory, OnePersonWithAHundredThousandAttemptsAtOneLevel) {
  Curriculum course = test::courseOf({test::levelNamed("a", 3), test::levelNamed("b", 3, {"a"})});
  course.levels[0].mastery.cusum = CusumRule{0.1, 0.25, 2.5};
  course.levels[0].mastery.lapsesAfter = FailureRule{3, 1000};
  std::vector<AttemptFacts> history;
  std::mt19937 random(1);
  for (int i = 0; i < 100'000; ++i)
    history.push_back(random() % 5 ? test::passedAttempt("a") : test::failedAttempt("a"));
  const auto progress = computeProgress(course, history, kNoon_us);
  EXPECT_EQ(progress[0].attempts, 100'000);
  EXPECT_EQ(progress[0].cusum.size(), 100'000U);
}

TEST(HostileHistory, ValuesAndTimesOfAnyKindGiveAState) {
  Curriculum course = test::courseOf({test::levelNamed("a", 1), test::levelNamed("b", 1, {"a"})});
  for (Level& level : course.levels) {
    level.mastery.lapsesAfter_days = 36'500;
    level.pass = {50.0, {{"passes", 1, std::nullopt, 2, "many", ""}}, 100};
  }
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(), kInf = std::numeric_limits<double>::infinity();
  std::vector<AttemptFacts> history;
  for (const std::int64_t time : {INT64_MIN, INT64_MAX, std::int64_t{0}, std::int64_t{-1}, kNoon_us})
    for (const double value : {kNaN, kInf, -kInf, 1e308, -1e308}) {
      AttemptFacts attempt = test::passedAttempt("a", time);
      attempt.points = value;
      attempt.metrics = {{"passes", 1, value}, {"passes", 1, 0}, {"", -1, value}};
      attempt.criticalErrors = time == 0 ? INT32_MIN : 0;
      attempt.length_us = time;
      history.push_back(attempt);
    }
  for (const std::int64_t now : {INT64_MIN, INT64_MAX, std::int64_t{0}, kNoon_us})
    for (const LevelProgress& level : computeProgress(course, history, now)) {
      EXPECT_TRUE(level.why.ends_with(".")) << level.why;
      EXPECT_EQ(level.why.find("nan"), std::string::npos) << level.why;
    }
}

TEST(HostileHistory, TheSameHistoryGivesTheSameProgress) {
  const auto course = loadCurriculum("central_line");
  ASSERT_TRUE(course) << course.error().message;
  std::mt19937 random(3);
  const auto history = someHistory(*course, random);
  const auto once = computeProgress(*course, history, kNoon_us), twice = computeProgress(*course, history, kNoon_us);
  for (std::size_t i = 0; i < once.size(); ++i) {
    EXPECT_EQ(once[i].why, twice[i].why);
    EXPECT_EQ(once[i].cusum, twice[i].cusum);
  }
}

}  // namespace
}  // namespace insonate
