#pragma once

#include <insonate/curriculum/AttemptFacts.h>
#include <insonate/curriculum/Curriculum.h>
#include <insonate/curriculum/Unlocking.h>

#include <cstdint>
#include <span>
#include <string>

namespace insonate {

/// How far someone is, as worked out from their attempts when it was last asked for.
struct Standing {
  std::string curriculum{};
  int curriculumVersion = 0;
  std::string level{};       ///< Level::name they are at; "": all are mastered
  int mastered = 0;          ///< levels
  std::string sentence{};    ///< why
  std::int64_t changes = 0;  ///< Member::changes it was worked out from

  bool operator==(const Standing&) const = default;
};

/// Someone's progress as a class list shows it: the first level in the curriculum's order that is open or lapsed.
/// `changes` is Member::changes, asked before the history that the progress was worked out from.
Standing standingOf(const Curriculum& curriculum, std::span<const LevelProgress> progress, std::int64_t changes);

/// Who needs their instructor.
enum class Concern {
  None,
  Slipped,  ///< a level that was mastered has lapsed
  Stuck,    ///< the last kStuckAfter attempts at an open level all failed
};
inline constexpr int kStuckAfter = 5;

/// Where someone is, from all their attempts.
struct PersonStanding {
  Standing standing{};
  Concern concern = Concern::None;
  std::string sentence{};  ///< of the level that is of concern, else of the one they are at
};
PersonStanding personStanding(const Curriculum& curriculum, std::span<const AttemptFacts> history,
                              std::span<const LevelProgress> progress, std::int64_t changes);

}  // namespace insonate
