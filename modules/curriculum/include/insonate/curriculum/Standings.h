#pragma once

#include <insonate/curriculum/AttemptFacts.h>
#include <insonate/curriculum/Curriculum.h>
#include <insonate/curriculum/Unlocking.h>

#include <cstdint>
#include <span>
#include <string>

namespace insonate {

/// Reason why a trainee needs the instructor's attention.
enum class Concern {
  None,
  Slipped,  ///< a level that was mastered has lapsed
  Stuck,    ///< the last kStuckAfter attempts at an open level all failed
};
inline constexpr int kStuckAfter = 5;

/// Progress of one trainee, computed from all attempts.
struct Standing {
  std::string curriculum{};
  int curriculumVersion = 0;
  std::string level{};  ///< name of the trainee's present level (Level::name); "": all levels are mastered
  int mastered = 0;     ///< number of mastered levels
  Concern concern = Concern::None;
  std::string sentence{};  ///< sentence about the level to which `concern` refers, else about the present level
  /// Member::changes when the standing was computed; a different value shows that the standing is outdated
  std::int64_t changes = 0;
  std::int64_t from_us = 0;  ///< time at which the standing was computed, since 1970, UTC
  /// time from which the standing may change without a new attempt, because mastery of a level lapses
  std::int64_t until_us = 0;

  bool operator==(const Standing&) const = default;
};

/// Version of the rules of computeStanding(). Increase the version with each change after which computeStanding() gives
/// another result for the same history, so that standings that an earlier version of the program stored are computed
/// again.
inline constexpr int kStandingRules = 3;

/// Computes a trainee's progress for the table of a class. The present level is the first level in the curriculum's
/// order that is open or lapsed. `progress`: result of computeProgress() for `history` at `now_us`. `changes`:
/// Member::changes, which must be read before the history.
Standing computeStanding(const Curriculum& curriculum, std::span<const AttemptFacts> history,
                         std::span<const LevelProgress> progress, std::int64_t now_us, std::int64_t changes);

}  // namespace insonate
