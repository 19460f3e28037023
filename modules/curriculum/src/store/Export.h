#pragma once

#include "store/sql/Transaction.h"

#include <string>

namespace insonate::store {

/// Exports all data of the database except passwords as one JSON object: {"schema": N, "people": [{...}, ...], ...},
/// with columns by name; attempts also have "voided", "broke_off", "assistance" and "passed".
std::string exported(Transaction& transaction);

}  // namespace insonate::store
