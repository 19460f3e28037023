#pragma once

#include "../class/ClassReading.h"

#include <insonate/curriculum/AttemptStore.h>
#include <insonate/curriculum/CommentStore.h>
#include <insonate/curriculum/Implausible.h>

#include <cstdint>
#include <map>
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
  /// Reasons by attempt id, for attempts that an instructor should look at.
  std::map<std::string, std::vector<Implausible>> implausible{};
  std::map<std::string, CommentStore::Count> comments{};  ///< numbers of comments, by attempt id
  std::map<std::string, int> forms{};  ///< numbers of checklists and ratings that were handed in, by attempt id
};
Result<PersonFacts> readPerson(const SignedIn& by, const std::string& person,
                               const std::optional<Curriculum>& curriculum, std::int64_t now_us);

/// Returns the numbers of checklists and ratings about a person's attempts, by attempt id.
Result<std::map<std::string, int>> formCounts(const SignedIn& by, const std::string& person);

}  // namespace insonate::review
