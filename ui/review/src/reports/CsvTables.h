#pragma once

#include "../class/ClassDesk.h"
#include "../person/PersonReading.h"

#include <string>

namespace insonate::review {

/// A line for each person of the class, with means of the last attempts; without formulas (curriculum/Csv.h).
std::string classCsv(const ClassDesk& desk);
/// A line for each attempt of a person, in their order, with all metrics.
std::string attemptsCsv(const PersonFacts& facts);

}  // namespace insonate::review
