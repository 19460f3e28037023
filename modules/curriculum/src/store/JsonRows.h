#pragma once

#include "store/sql/Row.h"

#include <nlohmann/json_fwd.hpp>

#include <vector>

namespace insonate::store {

/// Returns a list of objects, one for each row, with the values under the names of their columns. NULL becomes null;
/// the texts in columns named "metrics" and "answers" are read as JSON.
nlohmann::ordered_json jsonRows(const std::vector<const char*>& columns, const std::vector<Row>& rows);

}  // namespace insonate::store
