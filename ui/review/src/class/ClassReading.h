#pragma once

#include "HeatMap.h"

#include <insonate/curriculum/CohortStore.h>
#include <insonate/curriculum/Curriculum.h>
#include <insonate/curriculum/Implausible.h>
#include <insonate/curriculum/SignedIn.h>

#include <optional>
#include <string>
#include <vector>

/// Queries of Review to the store, on the account's thread.
namespace insonate::review {

/// An attempt to look at, and why.
struct FlaggedAttempt {
  AttemptFacts facts{};
  std::vector<Implausible> flags{};
};

struct ClassFacts {
  Cohort cohort{};
  std::optional<Curriculum> curriculum{};
  std::string trouble{};  ///< why there is no curriculum, and what to do
  std::vector<Member> learners{};
  HeatMap heat{};                             ///< of kLastAttempts of each learner
  std::vector<FlaggedAttempt> implausible{};  ///< of these, the latest first
};
Result<ClassFacts> readClass(const SignedIn& by, const Cohort& cohort);

/// The published version by which a cohort is taught.
Result<Curriculum> curriculumOf(const SignedIn& by, const Cohort& cohort);

}  // namespace insonate::review
