#pragma once

#include <algorithm>

namespace insonate {

/// The two points of a row between which a position lies, for linear interpolation; the outermost go on beyond the
/// ends.
struct Interval {
  int low, high;
  double fraction;  ///< of the way from low to high
};

inline Interval intervalAt(double position, int points) {
  const double at = std::clamp(position, 0.0, points - 1.0);
  const int low = std::min(static_cast<int>(at), std::max(points - 2, 0));
  return {low, std::min(low + 1, points - 1), at - low};
}

}  // namespace insonate
