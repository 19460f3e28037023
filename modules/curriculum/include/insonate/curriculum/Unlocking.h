#pragma once

#include <insonate/curriculum/AttemptFacts.h>
#include <insonate/curriculum/Curriculum.h>

#include <cstdint>
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

/// Where a person stands in one level, and why.
struct LevelProgress {
  std::string level{};
  LevelState state = LevelState::Locked;
  std::string why{};                       ///< one sentence for the trainee
  std::optional<std::int64_t> since_us{};  ///< when this state began; none: from the start
  int attempts = 0;                        ///< that count (Judgement.h)
  int passes = 0;                          ///< of those
  int passesInARow = 0;                    ///< up to the last attempt, after the last lapse
  bool lastPassed = false;
  int standardsMet = 0;         ///< in the last attempt that counts
  std::vector<double> cusum{};  ///< LC-CUSUM score after each attempt; empty where the level has no such rule
  bool cusumSignalled = false;
};

/// Where a person stands in each level, in the curriculum's order. Pure: the same input gives the same output.
///
/// An attempt counts for the level of its name, in any version of the curriculum, if its procedure is the level's. It
/// is judged by this curriculum's rules. `history` is in the order in which attempts arrived; their times only tell
/// days without practice. Since clocks jump, a time is taken to be no earlier than those before it and no later than
/// `now_us`.
///
/// Mastered: the passes in a row are reached, and LC-CUSUM has signalled at some time, where it is asked for. A lapse
/// asks for the passes in a row anew, not for another signal. What was mastered stays so while a prerequisite has
/// lapsed, since a level is practised by those that build on it; what was not is locked until the prerequisite is
/// renewed. Passes made while a level was locked count once it opens.
std::vector<LevelProgress> progressOf(const Curriculum& curriculum, std::span<const AttemptFacts> history,
                                      std::int64_t now_us);

}  // namespace insonate
