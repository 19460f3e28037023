#pragma once

#include <optional>
#include <span>

namespace insonate {

/// Comparison of two groups by the ranks of their values.
struct RankComparison {
  double u = 0;  ///< Mann-Whitney U of the first group: number of pairs in which the first group's value is greater,
                 ///< ties counted half
  /// U / (n m), with n and m the sizes of the groups: probability that a value of the first group exceeds a value of
  /// the second, ties counted half.
  double superiority = 0;
  double effect = 0;  ///< rank-biserial correlation (Cliff's delta), 2 superiority - 1; -1 to 1
  double p = 1;       ///< two-sided p-value of the Mann-Whitney test
  /// true: p is exact; false: p is computed from the normal approximation
  bool exact = false;
};

/// Minimum number of values per group for a comparison: with 3 against 3, no difference has p below 0.1.
inline constexpr std::size_t kFewestCompared = 4;

/// Compares two groups by the Mann-Whitney test (Ann Math Stat 1947, 18:50). For up to 20 values per group, p is exact:
/// the share of all arrangements (tied values have their mean rank) whose U is at least as far from n m / 2 as the
/// observed U. For more values, p is computed from the normal approximation with corrections for ties and continuity.
/// No value if a group has fewer than kFewestCompared values or a value that is not finite.
std::optional<RankComparison> compareRanks(std::span<const double> first, std::span<const double> second);

}  // namespace insonate
