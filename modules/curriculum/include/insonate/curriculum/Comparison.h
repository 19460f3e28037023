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
  bool exact = false;      ///< p by all arrangements, else by the normal approximation with ties and continuity
};

/// Mann and Whitney (Ann Math Stat 1947, 18:50). Exact without ties and up to 20 values a group. None where a group is
/// empty or holds what is not finite.
std::optional<RankComparison> compareRanks(std::span<const double> first, std::span<const double> second);

}  // namespace insonate
