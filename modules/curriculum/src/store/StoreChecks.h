#pragma once

#include "store/sql/Transaction.h"

#include <insonate/core/Result.h>

namespace insonate::store {

/// Whether all pages of a file can be read, in half a second for 100 MB. A server looks after its own.
Result<void> checkPages(Connection& connection);

/// All pages, keys and hashes, as StoreUpkeep::verify().
Result<void> verifyAll(Transaction& transaction);

}  // namespace insonate::store
