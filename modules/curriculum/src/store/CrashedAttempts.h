#pragma once

#include "store/sql/Transaction.h"

#include <insonate/core/Result.h>

namespace insonate::store {

class Core;

/// Stores the identity of this process before its first attempt.
void keepRun(Transaction& transaction, const Core& core);

/// Marks the open attempts of this workstation's dead processes abandoned. Attempts of running processes, and of other
/// workstations, stay open.
Result<void> abandonCrashed(Core& core);

}  // namespace insonate::store
