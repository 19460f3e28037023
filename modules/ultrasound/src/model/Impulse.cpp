#include "model/Impulse.h"

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

/// Integral of the quadratic B-spline from the left.
double splineBefore(double x) {
  if (x <= -1.5) return 0;
  if (x >= 1.5) return 1;
  if (x < -0.5) return (x + 1.5) * (x + 1.5) * (x + 1.5) / 6;
  if (x > 0.5) return 1 - (1.5 - x) * (1.5 - x) * (1.5 - x) / 6;
  return 0.5 + x * (0.75 - x * x / 3);
}

}  // namespace

Impulse::Impulse(double gate, double width) {
  width = std::clamp(width, kNarrowest_gates, kWidest_gates);
  first = static_cast<int>(std::ceil(gate - width / 2 - 1.5));
  count = std::min(kMost, static_cast<int>(std::floor(gate + width / 2 + 1.5)) - first + 1);
  for (int k = 0; k < count; ++k) {
    const double off = first + k - gate;
    weight[k] = static_cast<float>((splineBefore(off + width / 2) - splineBefore(off - width / 2)) / width);
  }
}

}  // namespace insonate
