#include "OutlineFit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace insonate::segmentation {
namespace {

constexpr int kRays = VesselOutline::kRays;
/// From a ray to the next, the wall moves by no more steps than this; what a step costs.
constexpr int kMostBend = 3;
constexpr double kBend = 0.4;
/// What a step away from the expected radius costs, at most what a clear wall is worth.
constexpr double kUnexpected = 0.06, kMostUnexpected = 6;

}  // namespace

OutlineFit::OutlineFit(const CtVolume& blurred, double largest_mm)
    : ct_(blurred),
      indexFromPatient_(blurred.geometry.indexFromPatient()),
      steps_(static_cast<int>(largest_mm / kStep_mm)) {}

/// Along each ray, what lies inside the wall should look like blood: the sum of unlikeness - 1 up to the wall is
/// smallest. The walls of all rays together are the cheapest closed way (dynamic programming over two turns, of which
/// the middle is free of where it began).
void OutlineFit::fit(VesselOutline& outline, const BloodLevel& level, const std::array<double, kRays>* expected) const {
  std::vector<double> wall(std::size_t(kRays) * steps_);
  const Vec3 centre = indexFromPatient_ * outline.centre_mm;
  for (int n = 0; n < kRays; ++n) {
    const double angle = 2 * std::numbers::pi * n / kRays;
    const Vec3 step =
        indexFromPatient_.linear * (outline.right * std::cos(angle) + outline.down * std::sin(angle)) * kStep_mm;
    double sum = 0;
    for (int r = 0; r < steps_; ++r) {
      // Wall r lies behind sample r.
      sum += level.unlikeness(sampleLinear(ct_, centre + step * (r + 0.5))) - 1;
      const double off = expected ? (r + 1) - (*expected)[n] / kStep_mm : 0;
      wall[std::size_t(n) * steps_ + r] = sum + std::min(kUnexpected * off * off, kMostUnexpected);
    }
  }

  constexpr int kTurns = 2;
  std::vector<double> cost(wall.begin(), wall.begin() + steps_), next(steps_);
  std::vector<std::int16_t> cameFrom(std::size_t(kTurns) * kRays * steps_);
  for (int n = 1; n < kTurns * kRays; ++n) {
    for (int r = 0; r < steps_; ++r) {
      int best = r;
      double least = std::numeric_limits<double>::max();
      for (int from = std::max(0, r - kMostBend); from <= std::min(steps_ - 1, r + kMostBend); ++from) {
        const double way = cost[from] + kBend * (r - from) * (r - from);
        if (way < least) least = way, best = from;
      }
      next[r] = least + wall[std::size_t(n % kRays) * steps_ + r];
      cameFrom[std::size_t(n) * steps_ + r] = static_cast<std::int16_t>(best);
    }
    cost.swap(next);
  }
  int r = static_cast<int>(std::ranges::min_element(cost) - cost.begin());
  for (int n = kTurns * kRays - 1; n >= kRays / 2; --n) {
    if (n < kRays + kRays / 2) outline.radius_mm[n % kRays] = kStep_mm * (r + 1);
    r = cameFrom[std::size_t(n) * steps_ + r];
  }
}

}  // namespace insonate::segmentation
