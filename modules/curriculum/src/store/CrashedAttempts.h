#pragma once

#include "store/sql/Transaction.h"

#include <insonate/core/Result.h>

namespace insonate::store {

class Core;

/// Keeps who this process is, before it begins its first attempt.
void keepRun(Transaction& transaction, const Core& core);

/// Tells the open attempts of this workstation's dead processes abandoned. Those of processes that live, and of other
/// workstations, stay open.
Result<void> abandonCrashed(Core& core);

}  // namespace insonate::store
