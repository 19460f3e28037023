#pragma once

#include "store/sql/Transaction.h"

#include <string>

namespace insonate::store {

class Core;

/// Notes that a fact waits for the server; in the transaction that keeps the fact. A fact that waits already waits on
/// under a new number, so that an upload under way cannot take it for sent. A server has no outbox.
void putIntoOutbox(Transaction& transaction, const Core& core, const std::string& kind, const std::string& id);

}  // namespace insonate::store
