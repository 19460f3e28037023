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

/// Progress of one trainee, from all attempts.
struct Standing {
  std::string curriculum{};
  int curriculumVersion = 0;
  std::string level{};  ///< Level::name of the trainee's present level; "": all levels are mastered
  int mastered = 0;     ///< number of mastered levels
  Concern concern = Concern::None;
  std::string sentence{};     ///< explains the level that is of concern, else the present level
  std::int64_t changes = 0;   ///< Member::changes at the time of computation
  std::int64_t from_us = 0;   ///< time of computation
  std::int64_t until_us = 0;  ///< from this time on, the standing may change without any new attempt

  bool operator==(const Standing&) const = default;
};

/// Version of the rules of a Standing: increase it with each change of standingOf() for the same history, so that
/// standings stored by an older program are computed again.
inline constexpr int kStandingRules = 2;

/// Computes a trainee's progress for a class list: the present level is the first level in the curriculum's order that
/// is open or lapsed. `progress` is progressOf() of the history at `now_us`; `changes` is Member::changes, read before
/// the history.
Standing standingOf(const Curriculum& curriculum, std::span<const AttemptFacts> history,
                    std::span<const LevelProgress> progress, std::int64_t now_us, std::int64_t changes);

}  // namespace insonate
