#pragma once

#include "Answer.h"

#include <insonate/curriculum/StoreUpkeep.h>

#include <string>

namespace insonate::cli {

/// Returns the size of a curriculum database as JSON: {"database", "schema", "people", "classes", "attempts", "forms",
/// "audit_entries", "pending_uploads"}.
Json countsJson(const StoreFacts& facts);
/// Returns the size of a curriculum database as text: "6 people, 2 classes, ...".
std::string countsOf(const StoreFacts& facts);

}  // namespace insonate::cli
