#pragma once

#include <algorithm>
#include <cmath>
#include <span>

namespace insonate {

inline bool allFinite(std::span<const double> values) {
  return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

}  // namespace insonate
