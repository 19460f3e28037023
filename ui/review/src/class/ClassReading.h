#pragma once

#include <insonate/curriculum/CohortStore.h>
#include <insonate/curriculum/Curriculum.h>
#include <insonate/curriculum/OpeningStore.h>
#include <insonate/curriculum/SignedIn.h>
#include <insonate/teaching/AttemptNotes.h>
#include <insonate/teaching/HeatMap.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// Queries of Review to the store, on the account's thread.
namespace insonate::review {

struct ClassFacts {
  Cohort cohort{};
  std::int64_t read_us = 0;  ///< time of reading, since 1970, UTC
  std::optional<Curriculum> curriculum{};
  std::string error{};  ///< sentence that says why there is no curriculum, and what to do
  std::vector<Member> learners{};
  std::vector<TestOpening> openings{};        ///< openings of tests of the class and of tests for everyone, newest
                                              ///< first
  HeatMap heat{};                             ///< heat map over the last kLastAttempts of each learner
  std::map<std::string, int> ready{};         ///< testReadiness(), if a test of the class is open or opens later
  std::vector<AttemptFacts> unproven{};       ///< attempts that wait for acceptance (waitsForAcceptance()), likewise
  std::vector<FlaggedAttempt> implausible{};  ///< implausible attempts among the last attempts in `heat`, the latest
                                              ///< first
};
Result<ClassFacts> readClass(const SignedIn& by, const Cohort& cohort);

/// Returns for each test of the curriculum (Level::name) how many learners of the class could take it now, since they
/// have mastered its prerequisites. Reads the attempts of the whole class.
Result<std::map<std::string, int>> testReadiness(const SignedIn& by, const ClassFacts& facts);

/// Returns the published version of the curriculum assigned to a class.
Result<Curriculum> curriculumOf(const SignedIn& by, const Cohort& cohort);

}  // namespace insonate::review
