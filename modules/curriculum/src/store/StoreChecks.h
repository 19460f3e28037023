#pragma once

#include "store/sql/Transaction.h"

#include <insonate/core/Result.h>

namespace insonate::store {

/// Checks that all pages of an SQLite file can be read; takes half a second for 100 MB. Does nothing for a PostgreSQL
/// server, which checks its own pages.
Result<void> checkPages(Connection& connection);

/// Checks all pages and keys of the database, the hashes of curricula and the audit log; see StoreUpkeep::verify().
Result<void> verifyAll(Transaction& transaction);

}  // namespace insonate::store
