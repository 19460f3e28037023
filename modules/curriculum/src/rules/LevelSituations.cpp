#include "LevelRecord.h"

#include <insonate/curriculum/Judgement.h>
#include <insonate/curriculum/LevelSituations.h>
#include <insonate/curriculum/Unlocking.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace insonate {
namespace {

constexpr std::int64_t kBetween_us = 60'000'000;

/// All limits of a metric together.
struct Range {
  int version = 1;
  double least = -std::numeric_limits<double>::infinity(), most = std::numeric_limits<double>::infinity();

  double inside() const {
    if (std::isinf(least)) return std::isinf(most) ? 0 : most;
    return std::isinf(most) ? least : (least + most) / 2;
  }
};

AttemptFacts passing(const Curriculum& curriculum, const Level& level) {
  AttemptFacts facts;
  facts.curriculum = curriculum.name, facts.level = level.name, facts.procedure = level.procedure;
  facts.state = AttemptState::Completed, facts.succeeded = true, facts.points = 100;
  facts.proof = AttemptProof::Demonstration, facts.testConditions = TestConditions::Opened;
  std::map<std::string, Range> ranges;
  for (const MetricStandard& one : level.pass.standards) {
    Range& range = ranges[one.metric];
    range.version = one.version;
    if (one.minimum) range.least = std::max(range.least, *one.minimum);
    if (one.maximum) range.most = std::min(range.most, *one.maximum);
  }
  for (const auto& [metric, range] : ranges) facts.metrics.push_back({metric, range.version, range.inside()});
  return facts;
}

/// Facts of an attempt that fails by missing as few standards as possible.
AttemptFacts failing(const Curriculum& curriculum, const Level& level) {
  AttemptFacts facts = passing(curriculum, level);
  for (const MetricStandard& one : level.pass.standards) {
    const auto metric = std::ranges::find(facts.metrics, one.metric, &MetricFact::id);
    metric->value = one.maximum ? *one.maximum + 1 : *one.minimum - 1;
    if (!judge(level.pass, facts).passed) return facts;
  }
  facts.criticalErrors = 1;
  return facts;
}

/// Number of consecutive passes that master a level; a longer story is cut.
int passesFor(const MasteryRule& rule) {
  constexpr int kMost = 600;
  return std::min(fewestAttempts(rule), kMost);
}

class Story {
 public:
  Story(const Curriculum& curriculum, const Level& level) : curriculum_(curriculum), level_(level) {}

  std::vector<LevelSituation> told() {
    using enum LevelSituation::When;
    tell(Beginning, std::nullopt);
    if (!level_.prerequisites.empty()) {
      masterFoundations(level_);
      tell(Reached, LevelState::Open);
    }
    practise(failing(curriculum_, level_));
    tell(AfterFailure, LevelState::Open);
    const int passes = passesFor(level_.mastery);
    for (int pass = 1; pass <= passes; ++pass) {
      practise(passing(curriculum_, level_));
      if (pass == 1 && passes > 1) tell(AfterPass, LevelState::Open);
    }
    tell(Mastered, LevelState::Mastered);
    // If a prerequisite lapses as well, the level is locked instead.
    if (const auto& days = level_.mastery.lapsesAfter_days) {
      now_us_ += (*days + 1) * kDay_us;
      if (turns_.back().when == Mastered) tell(Lapsed, std::nullopt);
    }
    return std::move(turns_);
  }

 private:
  void practise(AttemptFacts facts) {
    facts.begun_us = now_us_ += kBetween_us;
    history_.push_back(std::move(facts));
  }
  void masterFoundations(const Level& level) {
    for (const std::string& name : level.prerequisites) {
      const Level& needed = *curriculum_.level(name);
      if (std::ranges::find(history_, name, &AttemptFacts::level) != history_.end()) continue;
      masterFoundations(needed);
      for (int pass = 0; pass < passesFor(needed.mastery); ++pass) practise(passing(curriculum_, needed));
    }
  }
  /// Omits a stage if the rules lead to a state other than its name, for example with limits that cannot be met.
  void tell(LevelSituation::When when, std::optional<LevelState> state) {
    const auto progress = computeProgress(curriculum_, history_, now_us_);
    const auto here = std::ranges::find(progress, level_.name, &LevelProgress::level);
    if (!state || here->state == *state) turns_.push_back({when, here->why});
  }

  const Curriculum& curriculum_;
  const Level& level_;
  std::vector<AttemptFacts> history_;
  std::int64_t now_us_ = kBetween_us;
  std::vector<LevelSituation> turns_;
};

}  // namespace

std::vector<LevelSituation> levelSituations(const Curriculum& curriculum, std::string_view level) {
  return Story(curriculum, *curriculum.level(level)).told();
}

}  // namespace insonate
