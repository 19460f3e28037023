#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace insonate {

inline std::vector<double> sortedOf(std::span<const double> values) {
  std::vector<double> sorted(values.begin(), values.end());
  std::ranges::sort(sorted);
  return sorted;
}

/// Returns a quantile by type 7 of Hyndman and Fan (see quantile()). `sorted` is in rising order and has at least one
/// value.
inline double quantileOfSorted(std::span<const double> sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const double part = place - static_cast<double>(below);
  return part == 0 ? sorted[below] : std::lerp(sorted[below], sorted[below + 1], part);
}

}  // namespace insonate
