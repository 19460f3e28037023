#pragma once

#include "../class/ClassReading.h"

#include <insonate/curriculum/AttemptStore.h>
#include <insonate/curriculum/Implausible.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace insonate::review {

/// Number of attempts on one page.
inline constexpr int kPage = 200;

/// All facts that Review shows about one person, queried on the account's thread.
struct PersonFacts {
  Person person{};
  std::optional<Curriculum> curriculum{};
  std::vector<AttemptFacts> history{};  ///< in the order of arrival
  std::vector<LevelProgress> progress{};
  std::optional<Standing> standing{};                             ///< with a curriculum
  std::vector<KeptAttempt> newest{};                              ///< the first kPage
  std::map<std::string, std::vector<Implausible>> implausible{};  ///< attempts to look at, by their ids
};
Result<PersonFacts> readPerson(const SignedIn& by, const std::string& person,
                               const std::optional<Curriculum>& curriculum, std::int64_t now_us);

}  // namespace insonate::review
