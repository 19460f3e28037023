#pragma once

#include <algorithm>

namespace insonate {

/// The two neighboring grid points on one axis between which a position lies, for linear interpolation; a position
/// beyond an end of the axis is moved to that end.
struct Interval {
  int low, high;
  double fraction;  ///< position between the points: 0 at low, 1 at high
};

inline Interval intervalAt(double position, int points) {
  const double at = std::clamp(position, 0.0, points - 1.0);
  const int low = std::min(static_cast<int>(at), std::max(points - 2, 0));
  return {low, std::min(low + 1, points - 1), at - low};
}

}  // namespace insonate
