#pragma once

#include "store/Core.h"

#include <insonate/curriculum/AttemptFacts.h>
#include <insonate/curriculum/AttemptSeal.h>

#include <string>

namespace insonate::store {

/// Makes the store's secret where it has none.
Result<void> keepSecret(Core& core);

/// Makes the seal for an attempt's id, person, curriculum and level.
Result<AttemptSeal> freshSeal(Transaction& transaction, const AttemptFacts& facts);
Result<NonceOrigin> originOfNonce(Transaction& transaction, const AttemptFacts& facts, const std::string& nonce);

}  // namespace insonate::store
