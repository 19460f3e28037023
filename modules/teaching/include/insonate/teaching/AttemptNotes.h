#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/AttemptStore.h>
#include <insonate/curriculum/CommentStore.h>
#include <insonate/curriculum/Curriculum.h>
#include <insonate/curriculum/Implausible.h>
#include <insonate/curriculum/SignedIn.h>

#include <map>
#include <string>
#include <vector>

namespace insonate {

/// Facts that lists of a person's attempts show beside each attempt, by AttemptFacts::id.
struct AttemptNotes {
  std::map<std::string, CommentStore::Count> comments{};
  std::map<std::string, int> forms{};  ///< numbers of checklists and ratings that were handed in by others
  /// reasons why an instructor should look at an attempt
  std::map<std::string, std::vector<Implausible>> implausible{};
};

/// Reads the numbers of comments and forms. The reasons stay empty.
Result<AttemptNotes> readAttemptCounts(const SignedIn& by, const std::string& person);
/// Reads all notes. `history`: AttemptStore::history() of the person.
Result<AttemptNotes> readAttemptNotes(const SignedIn& by, const std::string& person,
                                      const std::vector<AttemptFacts>& history);

/// An attempt that an instructor should look at, with the reasons.
struct FlaggedAttempt {
  AttemptFacts facts{};
  std::vector<Implausible> flags{};
};
/// Returns the implausible attempts among `attempts`, the latest first. An attempt is compared with all earlier ones.
std::vector<FlaggedAttempt> implausibleOf(std::vector<AttemptFacts> attempts);

/// Tells whether an attempt has ended without proof, so that it counts only after an instructor has accepted it.
bool isUnproven(const StoredAttempt& attempt);
/// Describes the outcome of an attempt with the reason why it was voided, and with its proof where a proof is missing:
/// "Passed, being verified by the server". `curriculum` may be null.
std::string outcomeText(const StoredAttempt& attempt, const Curriculum* curriculum);
/// Describes the reasons of AttemptNotes::implausible: "implausibly fast: time to vein 1.5 s, ...".
std::string implausibleText(const AttemptFacts& attempt, const std::vector<Implausible>& flags);
/// Formats a number of comments: "3, 1 unread"; for an instructor, "3, 1 unread by trainee". "" if there are none.
std::string commentText(const CommentStore::Count& count, bool isInstructor);

}  // namespace insonate
