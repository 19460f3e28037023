#pragma once

#include "store/sql/Transaction.h"

#include <insonate/core/Result.h>

namespace insonate::store {

class Core;

/// Stores the identity of this process in the database, before its first attempt, so that a crash can be detected
/// later.
void storeRun(Transaction& transaction, const Core& core);

/// Finds attempts that crashed processes of this workstation left open, and marks these attempts as abandoned. Attempts
/// of running processes, and attempts of other workstations, stay open.
Result<void> abandonCrashed(Core& core);

}  // namespace insonate::store
