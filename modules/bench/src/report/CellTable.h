#pragma once

#include <string>
#include <vector>

namespace insonate::bench {

/// A row of a table, as texts; the first row of a table is its header.
using Cells = std::vector<std::string>;

/// Returns a value as text with `digits` decimals; empty if the value is not finite.
std::string fixed(double value, int digits);
/// Returns a table as comma-separated text; cells must not contain commas.
std::string csv(const std::vector<Cells>& rows);
std::string markdown(const std::vector<Cells>& rows);

}  // namespace insonate::bench
