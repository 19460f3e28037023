#pragma once

#include "store/sql/Transaction.h"

#include <insonate/core/Result.h>
#include <insonate/curriculum/AttemptFacts.h>

#include <cstdint>

namespace insonate::store {

/// Fails if another attempt has the same recorded motion of probe and needle (AttemptFacts::handsHash). Recordings are
/// compared, too, since the database has no handsHash of attempts that an earlier schema stored.
Result<void> refuseKnownHands(Transaction& transaction, const AttemptFacts& facts);
/// Stores AttemptFacts::handsHash of an attempt with the time `now_us`. Storing it again is no error.
void storeHandsHash(Transaction& transaction, const AttemptFacts& facts, std::int64_t now_us);

}  // namespace insonate::store
