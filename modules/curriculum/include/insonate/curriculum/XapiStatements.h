#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/AttemptFacts.h>
#include <insonate/curriculum/Curriculum.h>
#include <insonate/curriculum/Person.h>

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace insonate {

/// Identity of a training site in Experience API (xAPI) statements.
struct XapiSite {
  std::string homePage{};  ///< IRI of the site, from which ids of accounts and activities are made:
                           ///< "https://training.example.org"
  bool byMail = false;     ///< true: people are identified by e-mail address if they have one; otherwise by account
};

/// An attempt for which no xAPI statement is written.
struct LeftOutAttempt {
  std::string attempt{};  ///< id of the attempt: AttemptFacts::id
  std::string why{};      ///< reason: "has not ended", "was abandoned before the skin was punctured"
};

struct XapiExport {
  std::vector<std::string> statements{};
  std::vector<LeftOutAttempt> leftOut{};
};

/// Makes Experience API 1.0.3 statements about a person's attempts, one JSON text each, ready to be sent to a learning
/// record store.
///
/// The verb is "passed" or "failed" for an ended attempt at a level, "completed" in free practice, and "abandoned" for
/// an abandoned attempt; a voided attempt voids its statement. Attempts that do not count (Judgement.h), and those of
/// other curricula or versions, are left out and listed with the reason, since a statement must not change after it was
/// sent. The assistance of a level is part of the definition of its activity, which learning record stores do not
/// compare. Ids of statements are UUIDs of version 5 made from the attempt's id, so that a learning record store
/// recognizes a repeated statement. Missing values, and times outside the years 1 to 9999, are left out instead of
/// being written as null. Fails if the home page is not an absolute http address.
Result<XapiExport> xapiStatements(const XapiSite& site, const Curriculum& curriculum, const Person& person,
                                  std::span<const AttemptFacts> attempts);
/// Returns a summary for the user: "Left out: 3 attempts (2 that have not ended, ...)."; "" if no attempt is left out.
std::string leftOutSentence(std::span<const LeftOutAttempt> leftOut);

/// Returns the statements as a JSON array.
std::string xapiText(std::span<const std::string> statements);
/// Writes the statements to a file as a JSON array.
Result<void> writeXapi(const std::filesystem::path& file, std::span<const std::string> statements);

}  // namespace insonate
