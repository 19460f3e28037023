#pragma once

#include <string>
#include <vector>

namespace insonate::bench {

/// A row of a table; the first is the header.
using Cells = std::vector<std::string>;

/// The value with that many decimals; empty if it is not finite.
std::string fixed(double value, int digits);
/// Comma-separated; cells must not hold commas.
std::string csv(const std::vector<Cells>& rows);
std::string markdown(const std::vector<Cells>& rows);

}  // namespace insonate::bench
