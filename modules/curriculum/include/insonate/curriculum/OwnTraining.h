#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/CurriculumStore.h>

#include <string>

namespace insonate {

/// Name for signing in, made from a full name: "Ada Lovelace" becomes "ada.lovelace". Letters of other scripts are left
/// out; a name without any other letter becomes "me".
std::string signInNameOf(const std::string& fullName);

/// Sets up a store without people for one person who trains alone, and signs this person in: as administrator of the
/// store, and as the only learner of a class that is taught by the built-in curriculum. Levels, results and learning
/// curves then work as in any class, and others can be added later. `fullName` has 1..200
/// characters; signInNameOf() is the name for signing in. Fails if the store has people already.
Result<SignedIn> setUpOwnTraining(const CurriculumStore& store, const std::string& fullName,
                                  const std::string& password);

}  // namespace insonate
