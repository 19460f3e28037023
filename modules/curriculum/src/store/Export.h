#pragma once

#include "store/sql/Transaction.h"

#include <string>

namespace insonate::store {

/// Everything but passwords as one JSON object: {"schema": N, "people": [{...}, ...], ...}, columns by their names;
/// of each attempt also "voided", "broke_off", "assistance" and "passed".
std::string exported(Transaction& transaction);

}  // namespace insonate::store
