#include "LevelRecord.h"

#include <insonate/curriculum/Judgement.h>
#include <insonate/curriculum/LcCusum.h>

#include <algorithm>

namespace insonate {

void LevelRecord::practised(std::int64_t time_us) {
  lapseByDays(time_us);
  lastPractice_us_ = time_us;
}

void LevelRecord::lapseByDays(std::int64_t time_us) {
  const auto& days = level_->mastery.lapsesAfter_days;
  if (skill_ != Skill::Mastered || !days || time_us - lastPractice_us_ <= *days * kDay_us) return;
  lapse(Cause::Days, lastPractice_us_ + *days * kDay_us);
}

void LevelRecord::lapse(Cause cause, std::int64_t time_us) {
  skill_ = Skill::Lapsed;
  cause_ = cause;
  skillSince_us_ = time_us;
  passesInARow_ = 0;
}

int LevelRecord::failuresSinceMastery() const {
  return static_cast<int>(std::ranges::count(sinceMastery_, false));
}

void LevelRecord::take(const AttemptFacts& attempt, std::int64_t time_us) {
  const Judgement judgement = judge(level_->pass, attempt);
  last_ = &attempt;
  lastPassed_ = judgement.passed;
  standardsMet_ = judgement.met;
  ++attempts_;
  passes_ += judgement.passed;
  passesInARow_ = judgement.passed ? passesInARow_ + 1 : 0;
  followCusum(judgement.passed);
  followMastery(judgement.passed, time_us);
}

void LevelRecord::followCusum(bool passed) {
  const auto& rule = level_->mastery.cusum;
  if (!rule) return;
  const LcCusum test{rule->acceptable, rule->unacceptable};
  const double before = cusum_.empty() ? 0 : cusum_.back();
  cusum_.push_back(std::max(0.0, before + (passed ? test.successWeight() : test.failureWeight())));
  cusumSignaled_ |= cusum_.back() >= rule->limit;
}

void LevelRecord::followMastery(bool passed, std::int64_t time_us) {
  const MasteryRule& rule = level_->mastery;
  if (skill_ == Skill::Mastered) {
    if (!rule.lapsesAfter) return;
    sinceMastery_.push_back(passed);
    if (static_cast<int>(sinceMastery_.size()) > rule.lapsesAfter->within) sinceMastery_.pop_front();
    if (failuresSinceMastery() >= rule.lapsesAfter->failures) lapse(Cause::Failures, time_us);
    return;
  }
  if (passesInARow_ < rule.consecutivePasses || (rule.cusum && !cusumSignaled_)) return;
  if (skill_ == Skill::Never) firstMastered_us_ = time_us;
  skill_ = Skill::Mastered;
  skillSince_us_ = time_us;
  sinceMastery_.clear();
}

}  // namespace insonate
