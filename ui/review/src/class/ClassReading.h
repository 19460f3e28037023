#pragma once

#include "HeatMap.h"

#include <insonate/curriculum/CohortStore.h>
#include <insonate/curriculum/Curriculum.h>
#include <insonate/curriculum/SignedIn.h>
#include <insonate/curriculum/Unlocking.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

/// What is asked of the store for Review, on the account's thread.
namespace insonate::review {

/// How many of each person's last attempts a class is looked at by.
inline constexpr int kLastAttempts = 10;

struct ClassFacts {
  Cohort cohort{};
  std::optional<Curriculum> curriculum{};
  std::string trouble{};  ///< why there is no curriculum, and what to do
  std::vector<Member> learners{};
  HeatMap heat{};  ///< of kLastAttempts of each learner
};
Result<ClassFacts> readClass(const SignedIn& by, const Cohort& cohort);

/// The published version by which a cohort is taught.
Result<Curriculum> curriculumOf(const SignedIn& by, const Cohort& cohort);

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
/// Asks for all attempts of a person, and keeps their standing in the store where it is another than it was.
Result<PersonStanding> readStanding(const SignedIn& by, const Member& member, const Curriculum& curriculum,
                                    std::int64_t now_us);

}  // namespace insonate::review
