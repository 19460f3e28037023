#pragma once

#include "store/Core.h"
#include "store/sql/Transaction.h"

#include <insonate/core/Result.h>

#include <string>
#include <vector>

namespace insonate::store {

/// Replaces the data of a person by a pseudonym that depends on the id alone; see PersonData::erase(). Does nothing if
/// the person was erased before. The caller deletes the recordings after the transaction. `by`: Person::id of the user;
/// "" for a workstation, which erases the people that its server has erased.
Result<void> erasePerson(Transaction& transaction, const Core& core, const std::string& person, const std::string& by);

/// Returns the ids of all attempts of people who were erased.
std::vector<std::string> erasedAttempts(Transaction& transaction);

}  // namespace insonate::store
