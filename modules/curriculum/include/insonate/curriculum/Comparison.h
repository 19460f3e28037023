#pragma once

#include <optional>
#include <span>

namespace insonate {

/// Two groups by the ranks of their values.
struct RankComparison {
  double u = 0;            ///< Mann and Whitney's U of the first group: pairs in which its value is greater, ties half
  double superiority = 0;  ///< U / (n m): chance that a value of the first group exceeds one of the second, ties half
  double effect = 0;       ///< rank-biserial correlation (Cliff's delta), 2 superiority - 1; -1 to 1
  double p = 1;            ///< two-sided
  bool exact = false;      ///< p by all arrangements of the values, else by the normal approximation
};

/// Fewer say nothing: of 3 against 3 no difference has p below 0.1.
inline constexpr std::size_t kFewestCompared = 4;

/// Mann and Whitney (Ann Math Stat 1947, 18:50). Up to 20 values a group p is exact: the share of all arrangements,
/// ties with their mean ranks, whose U lies as far from nm / 2 or farther. Above it is the normal approximation with
/// ties and continuity. None where a group has fewer than kFewestCompared values or one that is not finite.
std::optional<RankComparison> compareRanks(std::span<const double> first, std::span<const double> second);

}  // namespace insonate
