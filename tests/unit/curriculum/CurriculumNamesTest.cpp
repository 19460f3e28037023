#include "AttemptMaker.h"

#include <insonate/curriculum/Curriculum.h>
#include <insonate/curriculum/LcCusum.h>
#include <insonate/teaching/TeachingHere.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace insonate {
namespace {

using testing::HasSubstr;

TEST(CurriculumNames, ThePresetNamesOnlyWhatThereIs) {
  const auto curriculum = loadCurriculum("central_line");
  ASSERT_TRUE(curriculum) << curriculum.error().message;
  const auto here = teachingNames();
  ASSERT_TRUE(here) << here.error().message;
  const auto fine = checkNames(*curriculum, *here);
  EXPECT_TRUE(fine) << fine.error().message;
  for (const Level& level : curriculum->levels) {
    EXPECT_FALSE(level.mastery.source.empty()) << level.name;
    for (const MetricStandard& standard : level.pass.standards) EXPECT_FALSE(standard.source.empty()) << level.name;
  }
}

TEST(CurriculumNames, LimitsOfThePresetAreThoseThatWereCalibrated) {
  const auto curriculum = loadCurriculum("central_line");
  ASSERT_TRUE(curriculum) << curriculum.error().message;
  int tests = 0;
  for (const Level& level : curriculum->levels) {
    const auto& rule = level.mastery.cusum;
    if (!rule) continue;
    const LcCusum test{rule->acceptable, rule->unacceptable};
    const auto limit = calibratedLimit(test, 0.1, {50});
    ASSERT_TRUE(limit) << limit.error().message;
    EXPECT_NEAR(rule->limit, *limit, 0.005) << level.name;
    EXPECT_LE(signalRate(test, rule->limit, test.unacceptable, {50}), 0.1) << level.name;
    ++tests;
  }
  EXPECT_EQ(tests, 2);
}

TEST(CurriculumNames, NoStandardOfThePresetAsksForMoreThanExpertsReach) {
  const auto curriculum = loadCurriculum("central_line");
  ASSERT_TRUE(curriculum) << curriculum.error().message;
  int compared = 0;
  for (const Level& level : curriculum->levels) {
    const auto procedure = loadProcedure(level.procedure);
    ASSERT_TRUE(procedure) << procedure.error().message;
    const auto meanings = metricMeanings(*procedure);
    for (const MetricStandard& standard : level.pass.standards) {
      const auto meaning = std::ranges::find(meanings, standard.metric, &MetricMeaning::id);
      // Norms of counts are shares of attempts; of one attempt, none is asked for.
      if (!meaning->expert || meaning->unit.empty()) continue;
      ++compared;
      EXPECT_GE(standard.maximum.value_or(*meaning->expert), *meaning->expert) << level.name << ", " << standard.metric;
      EXPECT_LE(standard.minimum.value_or(*meaning->expert), *meaning->expert) << level.name << ", " << standard.metric;
    }
  }
  EXPECT_GT(compared, 20);
}

TEST(CurriculumNames, WhatIsMissingIsNamed) {
  TeachingNames known;
  known.cases = {"textbook"};
  known.procedures = {{"line", {"supine"}}};
  known.metrics = {{"passes", 2, "Passes", "", MetricMeaning::Better::Lower, {}, {}},
                   {"share", 1, "Share", "%", MetricMeaning::Better::Higher, {}, {}}};
  const Curriculum good = test::courseOf({test::levelNamed("a", 1)});
  EXPECT_TRUE(checkNames(good, known));
  const auto refusal = [&](void (*change)(Level&)) {
    Curriculum changed = good;
    change(changed.levels[0]);
    const auto fine = checkNames(changed, known);
    return fine ? "" : fine.error().message;
  };
  EXPECT_THAT(refusal([](Level& l) { l.caseName = "textbok"; }),
              HasSubstr("level 'a' names the unknown case 'textbok'; did you mean 'textbook'?"));
  EXPECT_THAT(refusal([](Level& l) { l.procedure = "heart"; }),
              HasSubstr("the unknown procedure 'heart'; known names are 'line'."));
  EXPECT_THAT(refusal([](Level& l) { l.position = "supin"; }), HasSubstr("the unknown position 'supin'; did you mean"));
  EXPECT_EQ(refusal([](Level& l) { l.position = "supine"; }), "");
  EXPECT_THAT(refusal([](Level& l) {
                l.pass.standards = {{"pases", 2, {}, 1, "", ""}};
              }),
              HasSubstr("the unknown metric 'pases'; did you mean 'passes'?"));
  EXPECT_THAT(refusal([](Level& l) {
                l.pass.standards = {{"passes", 1, {}, 1, "", ""}};
              }),
              HasSubstr("is of version 1 of the metric's definition; it is 2 now"));
  EXPECT_THAT(refusal([](Level& l) { l.pass.standards = {{"passes", 2, 1, {}, "", ""}}; }), HasSubstr("use 'most'"));
  EXPECT_THAT(refusal([](Level& l) { l.pass.standards = {{"share", 1, {}, 1, "", ""}}; }), HasSubstr("use 'least'"));
}

}  // namespace
}  // namespace insonate
