#pragma once

#include "store/Core.h"
#include "store/sql/Transaction.h"

#include <insonate/core/Result.h>
#include <insonate/curriculum/Person.h>

#include <string>

namespace insonate::store {

/// Erases the names of a person and the reasons that concern the person from the details of the audit log, in which
/// earlier programs wrote names. `person`: with the sign-in name before its erasure. The check of the log still
/// succeeds: an entry by `by` vouches for the other fields of each entry that is changed. Fails if such an entry was
/// changed by another program.
Result<void> eraseFromLog(Transaction& transaction, const Core& core, const Person& person, const std::string& by);

}  // namespace insonate::store
