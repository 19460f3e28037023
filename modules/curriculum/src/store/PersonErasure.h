#pragma once

#include "store/Core.h"
#include "store/sql/Transaction.h"

#include <insonate/core/Result.h>

#include <cstdint>
#include <string>
#include <vector>

namespace insonate::store {

/// Replaces the data of a person by a pseudonym that depends on the id alone; see PersonData::erase(). Does nothing if
/// the person was erased before. The caller deletes the recordings after the transaction. `by`: Person::id of the user;
/// "" for a workstation, which erases the people that its server has erased.
Result<void> erasePerson(Transaction& transaction, const Core& core, const std::string& person, const std::string& by);

/// Deletes the requests for videos of attempts, and ends their verification, since their recordings are deleted.
void endWorkOnRecordings(Transaction& transaction, const std::vector<std::string>& attempts, std::int64_t now_us);

/// Returns the ids of all attempts of people who were erased.
std::vector<std::string> erasedAttempts(Transaction& transaction);

}  // namespace insonate::store
