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
  Open,      ///< can be learned now
  Mastered,  ///< mastered; may still be practiced
  Lapsed,    ///< was mastered, and must be renewed now
};

inline constexpr std::int64_t kForever_us = std::numeric_limits<std::int64_t>::max();

/// State of one level for one person, with the reason.
struct LevelProgress {
  std::string level{};
  LevelState state = LevelState::Locked;
  std::string why{};  ///< a sentence for the trainee
  /// Time at which this state began; empty if it has held from the start or the level is locked.
  std::optional<std::int64_t> since_us{};
  int attempts = 0;      ///< number of attempts that count (Judgement.h)
  int passes = 0;        ///< number of passed attempts among these
  int passesInARow = 0;  ///< consecutive passes up to the last attempt, since the last lapse
  bool lastPassed = false;
  int standardsMet = 0;         ///< number of standards met in the last attempt that counts
  std::vector<double> cusum{};  ///< LC-CUSUM score after each attempt; empty if the level has no such rule
  bool cusumSignalled = false;
  /// Time until which the state stays the same without practice. Until then the sentence stays the same, too, unless
  /// the level is mastered.
  std::int64_t until_us = kForever_us;
};

/// Minimum number of attempts to master a level: all attempts pass, and LC-CUSUM signals if it is required.
int fewestAttempts(const MasteryRule& rule);

/// Returns a person's state in each level, in the curriculum's order. The same input always gives the same output.
///
/// An attempt counts (Judgement.h) for the level of its name, in any version of the curriculum, if its procedure is the
/// level's. It is judged by this curriculum's rules. `history` is in the order of arrival; the times of attempts only
/// count days without practice. Clocks jump: a time later than `now_us` or before 1970 is ignored, and no time is taken
/// to be earlier than those before it. An attempt that has not ended is ignored, and so is its time.
///
/// A level is mastered once the consecutive passes are reached and, where required, LC-CUSUM has signalled at some
/// time. After a lapse the consecutive passes are required again, but no new signal; failures that lead to a lapse are
/// counted from mastery on. A mastered level stays mastered while a prerequisite has lapsed; other levels are locked
/// until the prerequisite is renewed. Practice of a level counts as practice of its prerequisites. Passes made while a
/// level was locked count once it opens.
///
/// `curriculum` comes from parseCurriculum().
std::vector<LevelProgress> progressOf(const Curriculum& curriculum, std::span<const AttemptFacts> history,
                                      std::int64_t now_us);

}  // namespace insonate
