#pragma once

#include "../class/ClassController.h"
#include "../person/PersonReading.h"

#include <string>

namespace insonate::review {

/// Returns a table with one line for each person of the class and the means of the last attempts. Cells cannot be read
/// as formulas (curriculum/Csv.h).
std::string classCsv(const ClassController& controller);
/// Returns a table with one line for each attempt of a person, in their order, with all metrics.
std::string attemptsCsv(const PersonFacts& facts);

}  // namespace insonate::review
