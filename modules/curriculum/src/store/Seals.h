#pragma once

#include "store/Core.h"

#include <insonate/curriculum/AttemptFacts.h>
#include <insonate/curriculum/AttemptSeal.h>

#include <string>

namespace insonate::store {

/// Makes the store's secret if it has none.
Result<void> keepSecret(Core& core);

/// Makes a seal for the id, person, curriculum and level of an attempt.
Result<AttemptSeal> freshSeal(Transaction& transaction, const AttemptFacts& facts);
Result<NonceOrigin> originOfNonce(Transaction& transaction, const AttemptFacts& facts, const std::string& nonce);

}  // namespace insonate::store
