#include "AttemptMaker.h"

#include <insonate/curriculum/Implausible.h>

#include <gmock/gmock.h>

#include <algorithm>

namespace insonate {
namespace {

using test::passedAttempt;
using testing::ElementsAre;
using testing::IsEmpty;
using enum Implausible;

/// A minute long, 20 s from skin to vein, with a probe that showed the tip.
AttemptFacts plausible() {
  AttemptFacts facts = passedAttempt("first");
  facts.metrics = {{"time_to_vein_s", 1, 20.0},        {"passes", 1, 1.0},        {"vein_punctures", 1, 1.0},
                   {"needle_path_mm", 1, 31.0},        {"probe_path_mm", 1, 0.0}, {"vein_checks", 1, 0.0},
                   {"tip_in_picture_percent", 2, 80.0}};
  return facts;
}

AttemptFacts withValue(AttemptFacts facts, std::string_view metric, std::optional<double> value) {
  std::ranges::find(facts.metrics, metric, &MetricFact::id)->value = value;
  return facts;
}

TEST(Implausible, WhatHandsDoIsNotFlagged) {
  EXPECT_THAT(implausibilities(plausible()), IsEmpty());
  AttemptFacts open = plausible();
  open.state = AttemptState::Open, open.length_us = 0, open.metrics.clear();
  EXPECT_THAT(implausibilities(open), IsEmpty());
  AttemptFacts crashed = open;
  crashed.state = AttemptState::Abandoned;
  EXPECT_THAT(implausibilities(crashed), IsEmpty()) << "nothing is known of it";
}

TEST(Implausible, AProbeThatDidNothing) {
  const AttemptFacts blind = withValue(plausible(), "tip_in_picture_percent", std::nullopt);
  EXPECT_THAT(implausibilities(blind), ElementsAre(WithoutProbe));
  EXPECT_THAT(implausibilities(withValue(blind, "probe_path_mm", std::nullopt)), ElementsAre(WithoutProbe));
  EXPECT_THAT(implausibilities(withValue(blind, "probe_path_mm", 0.5)), IsEmpty());
  EXPECT_THAT(implausibilities(withValue(blind, "vein_checks", 1.0)), IsEmpty()) << "it found the vein before";
  AttemptFacts abandoned = blind;
  abandoned.state = AttemptState::Abandoned;
  EXPECT_THAT(implausibilities(abandoned), IsEmpty());
}

TEST(Implausible, LimitsOfTime) {
  EXPECT_THAT(implausibilities(withValue(plausible(), "time_to_vein_s", 1.5)), ElementsAre(FastToVein));
  EXPECT_THAT(implausibilities(withValue(plausible(), "time_to_vein_s", kFastToVein_s)), IsEmpty());
  EXPECT_THAT(implausibilities(withValue(plausible(), "time_to_vein_s", std::nullopt)), IsEmpty())
      << "it never got there";
  AttemptFacts brief = plausible();
  brief.length_us = 9'999'999;
  EXPECT_THAT(implausibilities(brief), ElementsAre(Short));
  brief.length_us = 10'000'000;
  EXPECT_THAT(implausibilities(brief), IsEmpty());
  brief.length_us = 4'000'000, brief.succeeded = false;
  EXPECT_THAT(implausibilities(brief), IsEmpty()) << "finished by mistake: a failure gains nothing";
  EXPECT_EQ(displayText(FastToVein, withValue(plausible(), "time_to_vein_s", 1.5)),
            "implausibly fast: time to vein 1.5\u00a0s");
  EXPECT_EQ(idOf(FastToVein), "fast_to_vein");
}

TEST(Implausible, ANeedleThatGotThereWithoutMoving) {
  EXPECT_THAT(implausibilities(withValue(plausible(), "needle_path_mm", 0.0)), ElementsAre(WithoutNeedlePath));
  EXPECT_THAT(implausibilities(withValue(plausible(), "needle_path_mm", std::nullopt)), ElementsAre(WithoutNeedlePath));
}

TEST(Implausible, ValuesOfAnEarlierAttemptToTheLastDigit) {
  PlausibilityCheck check;
  EXPECT_THAT(check.check(plausible()), IsEmpty());
  EXPECT_THAT(check.check(withValue(plausible(), "needle_path_mm", 31.0000001)), IsEmpty());
  AttemptFacts other = plausible();
  other.person = "another", other.id = "another";
  EXPECT_THAT(check.check(other), ElementsAre(SameValues));
  AttemptFacts nothing = withValue(plausible(), "passes", 0.0);
  nothing.state = AttemptState::Abandoned;
  EXPECT_THAT(check.check(nothing), IsEmpty());
  EXPECT_THAT(check.check(nothing), IsEmpty()) << "before the skin much is the same";
}

}  // namespace
}  // namespace insonate
