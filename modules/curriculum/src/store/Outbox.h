#pragma once

#include "store/sql/Transaction.h"

#include <string>

namespace insonate::store {

class Core;

/// Adds a fact to the outbox, where it waits for the server; in the transaction that stores the fact. A fact that
/// already waits gets a new number, so that an upload in progress does not take it for sent. A server has no outbox.
void putIntoOutbox(Transaction& transaction, const Core& core, const std::string& kind, const std::string& id);

}  // namespace insonate::store
