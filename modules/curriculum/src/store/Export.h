#pragma once

#include "store/sql/Transaction.h"

#include <string>

namespace insonate::store {

/// Everything but passwords as one JSON object: {"schema": N, "people": [{...}, ...], ...}, columns by their names.
std::string exported(Transaction& transaction);

}  // namespace insonate::store
