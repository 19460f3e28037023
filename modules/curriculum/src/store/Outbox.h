#pragma once

#include "store/sql/Transaction.h"

#include <string>

namespace insonate::store {

class Core;

/// Adds an attempt or form (`kind`, `id`) to the outbox, the list of data to be sent to the server; call it in the
/// transaction that stores the data. Data that already waits gets a new number, so that an upload in progress does not
/// mark the newer data as sent. Does nothing on a server.
void putIntoOutbox(Transaction& transaction, const Core& core, const std::string& kind, const std::string& id);

}  // namespace insonate::store
