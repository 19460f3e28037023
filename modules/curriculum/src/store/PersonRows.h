#pragma once

#include "store/sql/Transaction.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace insonate::store {

/// Returns all rows about a person, and all rows that the person made, as one object: {"account": [...], "classes":
/// [...], ...}. Names of columns that end in _us are times in microseconds since 1970, UTC.
nlohmann::ordered_json rowsOfPerson(Transaction& transaction, const std::string& person);

/// Returns a table (CSV) of the attempts of a person: attemptColumns() and a column for each version of a metric's
/// definition, "time_to_vein_s, version 2".
std::string attemptsOfPerson(Transaction& transaction, const std::string& person);

}  // namespace insonate::store
