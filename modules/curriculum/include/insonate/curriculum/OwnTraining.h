#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/CurriculumStore.h>

#include <string>

namespace insonate {

/// Returns a name for signing in that is made from a full name: "Ada Lovelace" becomes "ada.lovelace". Only ASCII
/// letters and digits are kept; if none is left, the name is "me".
std::string signInNameOf(const std::string& fullName);

/// Sets up an empty database for one person who trains alone, and signs this person in. The person becomes
/// administrator of the database and the only learner of a class that is taught by the built-in curriculum. Levels,
/// results and learning curves then work as in any class, and other people can be added later. `fullName` has 1 to 200
/// characters; the name for signing in is signInNameOf(fullName). Fails if the store has people already.
Result<SignedIn> setUpOwnTraining(const CurriculumStore& store, const std::string& fullName,
                                  const std::string& password);

}  // namespace insonate
