#pragma once

#include "store/sql/Transaction.h"

#include <insonate/core/Result.h>

namespace insonate::store {

/// Checks that all pages of an SQLite file can be read: half a second for 100 MB. A PostgreSQL server checks its own.
Result<void> checkPages(Connection& connection);

/// All pages, keys and hashes, as StoreUpkeep::verify().
Result<void> verifyAll(Transaction& transaction);

}  // namespace insonate::store
