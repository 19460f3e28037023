#pragma once

#include "store/Core.h"

#include <insonate/curriculum/AttemptFacts.h>
#include <insonate/curriculum/AttemptSeal.h>

#include <string>

namespace insonate::store {

/// Makes the database's secret, from which nonces and keys of attempts are derived, if there is none yet.
Result<void> storeSecret(Core& core);

/// Makes nonce and key (AttemptSeal) for an attempt with this id, person, curriculum and level.
Result<AttemptSeal> freshSeal(Transaction& transaction, const AttemptFacts& facts);
/// Returns the database's secret, in hexadecimal digits. A database may send its secret only to its own server.
Result<std::string> secretText(Transaction& transaction);
/// Tells whether the store with this secret (secretText()) issued `nonce`; see AttemptStore::originOf().
NonceOrigin originBySecret(const std::string& secret, const AttemptFacts& facts, const std::string& nonce);
Result<NonceOrigin> originOfNonce(Transaction& transaction, const AttemptFacts& facts, const std::string& nonce);

}  // namespace insonate::store
