#pragma once

#include <insonate/curriculum/AttemptFacts.h>
#include <insonate/curriculum/Curriculum.h>

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace insonate {

inline constexpr std::int64_t kDay_us = 86'400'000'000;

/// Computes a trainee's skill at one level from the attempts, without regard to prerequisites. Add attempts in the
/// order of AttemptStore::history(), with times that do not decrease.
class LevelRecord {
 public:
  enum class Skill { Never, Mastered, Lapsed };
  enum class Cause { Days, Failures };

  explicit LevelRecord(const Level& level) : level_(&level) {}

  /// Adds an attempt that counts at this level; call practised() with its time first.
  void take(const AttemptFacts& attempt, std::int64_t time_us);
  /// Records practice at this level or at a level that builds on it. If too many days have passed since the last
  /// practice, mastery lapses first.
  void practised(std::int64_t time_us);
  void lapseByDays(std::int64_t time_us);

  const Level& level() const { return *level_; }
  Skill skill() const { return skill_; }
  Cause cause() const { return cause_; }  ///< reason why mastery lapsed last
  std::int64_t skillSince_us() const { return skillSince_us_; }
  std::int64_t firstMastered_us() const { return firstMastered_us_; }
  std::int64_t lastPractice_us() const { return lastPractice_us_; }
  const AttemptFacts* last() const { return last_; }  ///< last attempt that counts

  int attempts() const { return attempts_; }
  int passes() const { return passes_; }
  int consecutivePasses() const { return passesInARow_; }
  bool lastPassed() const { return lastPassed_; }
  int standardsMet() const { return standardsMet_; }
  /// Returns the number of failures since mastery, among the last FailureRule::within attempts.
  int failuresSinceMastery() const;
  const std::vector<double>& cusum() const { return cusum_; }
  bool cusumSignaled() const { return cusumSignaled_; }

 private:
  void followCusum(bool passed);
  void followMastery(bool passed, std::int64_t time_us);
  void lapse(Cause cause, std::int64_t time_us);

  const Level* level_;
  Skill skill_ = Skill::Never;
  Cause cause_ = Cause::Days;
  std::int64_t skillSince_us_ = 0, firstMastered_us_ = 0, lastPractice_us_ = 0;
  const AttemptFacts* last_ = nullptr;
  int attempts_ = 0, passes_ = 0, passesInARow_ = 0, standardsMet_ = 0;
  bool lastPassed_ = false;
  std::vector<double> cusum_;
  bool cusumSignaled_ = false;
  /// for each of the last FailureRule::within attempts since mastery: true if it was passed
  std::deque<bool> sinceMastery_;
};

}  // namespace insonate
