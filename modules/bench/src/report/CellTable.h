#pragma once

#include <string>
#include <vector>

namespace insonate::bench {

/// A row of a table; the first is the header.
using Cells = std::vector<std::string>;

/// Writes a value with `digits` decimals; empty if it is not finite.
std::string fixed(double value, int digits);
/// Writes comma-separated text; cells must not contain commas.
std::string csv(const std::vector<Cells>& rows);
std::string markdown(const std::vector<Cells>& rows);

}  // namespace insonate::bench
