#pragma once

#include <insonate/curriculum/AttemptFacts.h>
#include <insonate/curriculum/Curriculum.h>

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace insonate {

enum class LevelState {
  Locked,    ///< a prerequisite of the level is not mastered
  Open,      ///< the level can be learned now
  Mastered,  ///< the level is mastered, and may still be practiced
  Lapsed,    ///< the level was mastered, and must be passed again
};

inline constexpr std::int64_t kForever_us = std::numeric_limits<std::int64_t>::max();

/// State of one level for one trainee, with the reason.
struct LevelProgress {
  std::string level{};
  LevelState state = LevelState::Locked;
  std::string why{};      ///< reason for the state, a sentence for the trainee
  std::string summary{};  ///< `why` without the outcome of the last attempt, for a page that states it
  /// Time at which the state began; empty if the level is locked, or has been in this state from the start.
  std::optional<std::int64_t> since_us{};
  int attempts = 0;           ///< number of attempts at the level that count (Judgement.h)
  int passes = 0;             ///< number of passed attempts among `attempts`
  int consecutivePasses = 0;  ///< number of consecutive passes up to the last attempt, since mastery last lapsed
  bool lastPassed = false;
  int standardsMet = 0;         ///< number of standards met in the last attempt that counts
  std::vector<double> cusum{};  ///< LC-CUSUM score after each attempt; empty if the level has no such rule
  bool cusumSignaled = false;
  /// Time until which `state` stays the same if the trainee makes no attempt. `why` also stays the same until then,
  /// except for a mastered level, whose text counts the days.
  std::int64_t until_us = kForever_us;
};

/// Returns the minimum number of attempts with which a level can be mastered, all of them passed.
int fewestAttempts(const MasteryRule& rule);

/// Returns a trainee's progress at each level, in the curriculum's order. The same input always gives the same output.
///
/// An attempt that counts (Judgement.h) belongs to the level whose name is AttemptFacts::level, whatever the version of
/// the curriculum, if both have the same procedure. The attempt is judged by the rules of this curriculum. `history` is
/// in the order of AttemptStore::history(); times are only used to count days without practice. Clocks may be wrong: a
/// time later than `now_us` or before 1970 is ignored, and a time earlier than that of a previous attempt is replaced
/// by the time of that attempt. An attempt that has not ended is ignored.
///
/// A level is mastered when the required number of consecutive passes is reached and, if the level has a CusumRule,
/// LC-CUSUM has signaled at some time. After a lapse, the consecutive passes are required again, but no new signal. For
/// FailureRule, only failures after mastery count. A mastered level stays mastered while a prerequisite has lapsed;
/// levels that are not mastered are locked until the prerequisite is mastered again. Practice of a level counts as
/// practice of its prerequisites. Passes that were made while a level was locked count when the level opens.
///
/// `curriculum` comes from parseCurriculum().
std::vector<LevelProgress> computeProgress(const Curriculum& curriculum, std::span<const AttemptFacts> history,
                                           std::int64_t now_us);

}  // namespace insonate
