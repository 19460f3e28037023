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
  Locked,    ///< a prerequisite is not mastered
  Open,      ///< to be learnt now
  Mastered,  ///< and may be practised
  Lapsed,    ///< was mastered; to be renewed now
};

inline constexpr std::int64_t kForever_us = std::numeric_limits<std::int64_t>::max();

/// Where a person stands in one level, and why.
struct LevelProgress {
  std::string level{};
  LevelState state = LevelState::Locked;
  std::string why{};  ///< one sentence for the trainee
  /// When this state began; none: from the start, or locked.
  std::optional<std::int64_t> since_us{};
  int attempts = 0;      ///< that count (Judgement.h)
  int passes = 0;        ///< of those
  int passesInARow = 0;  ///< up to the last attempt, after the last lapse
  bool lastPassed = false;
  int standardsMet = 0;         ///< in the last attempt that counts
  std::vector<double> cusum{};  ///< LC-CUSUM score after each attempt; empty where the level has no such rule
  bool cusumSignalled = false;
  /// Until then the state stays as it is if nothing is done, and so does the sentence unless it is of a mastered level.
  std::int64_t until_us = kForever_us;
};

/// The smallest number of attempts that masters a level: all pass, and LC-CUSUM signals where it is asked for.
int fewestAttempts(const MasteryRule& rule);

/// Where a person stands in each level, in the curriculum's order. Pure: the same input gives the same output.
///
/// An attempt counts (Judgement.h) for the level of its name, in any version of the curriculum, if its procedure is the
/// level's. It is judged by this curriculum's rules. `history` is in the order in which attempts arrived; their times
/// only tell days without practice. Clocks jump: a time later than `now_us` or before 1970 is not believed, and none is
/// taken to be earlier than those before it. An open attempt tells nothing, not even a time.
///
/// Mastered: the passes in a row are reached, and LC-CUSUM has signalled at some time, where it is asked for. A lapse
/// asks for the passes in a row anew, not for another signal; failures that lead to it are counted from mastery on.
/// What was mastered stays so while a prerequisite has lapsed; what was not is locked until the prerequisite is
/// renewed. Practice of a level is practice of those it builds on. Passes made while a level was locked count once it
/// opens.
///
/// `curriculum` is one that parseCurriculum() gave.
std::vector<LevelProgress> progressOf(const Curriculum& curriculum, std::span<const AttemptFacts> history,
                                      std::int64_t now_us);

}  // namespace insonate
