#pragma once

#include "store/sql/Transaction.h"

#include <insonate/core/Result.h>
#include <insonate/curriculum/AttemptFacts.h>

#include <cstdint>

namespace insonate::store {

/// Fails if another attempt was made with the same motion of the hands, or if a store of an earlier schema kept the
/// same file for another attempt.
Result<void> refuseKnownHands(Transaction& transaction, const AttemptFacts& facts);
/// Stores the hash of the hands' motion for an attempt, as of `now_us`. Repeating it is no error.
void keepHands(Transaction& transaction, const AttemptFacts& facts, std::int64_t now_us);

}  // namespace insonate::store
