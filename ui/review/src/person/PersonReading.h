#pragma once

#include "../class/ClassReading.h"

#include <insonate/curriculum/AttemptStore.h>
#include <insonate/teaching/AttemptNotes.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace insonate::review {

/// Number of attempts that are queried at once.
inline constexpr int kPage = 200;

/// All facts that Review shows about one person, queried on the account's thread.
struct PersonFacts {
  Person person{};
  std::optional<Curriculum> curriculum{};
  std::vector<AttemptFacts> history{};  ///< attempts in the order in which the store received them
  std::vector<LevelProgress> progress{};
  std::optional<Standing> standing{};   ///< progress of the person; empty if there is no curriculum
  std::vector<StoredAttempt> newest{};  ///< the first kPage attempts, newest first
  AttemptNotes notes{};
};
Result<PersonFacts> readPerson(const SignedIn& by, const std::string& person,
                               const std::optional<Curriculum>& curriculum, std::int64_t now_us);

}  // namespace insonate::review
