#include "ClosedWay.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace insonate::segmentation {
namespace {

/// Cost for each step of deviation from the expected radius, and its maximum, which equals the gain of a clear wall.
constexpr double kUnexpected = 0.06, kMaxUnexpected = 6;

}  // namespace

Radii closedWay(RadialCost wall, const std::function<Bend(int)>& bendAt, const Radii* expected) {
  const int steps = wall.steps;
  if (expected)
    for (int n = 0; n < VesselOutline::kRays; ++n)
      for (int r = 0; r < steps; ++r) {
        const double off = (r + 1) - (*expected)[n] / wall.step_mm;
        wall.at(n, r) += std::min(kUnexpected * off * off, kMaxUnexpected);
      }

  std::vector<Bend> bends;
  for (int r = 0; r < steps; ++r) bends.push_back(bendAt(r));
  constexpr int kTurns = 2;
  std::vector<double> cost(wall.cost.begin(), wall.cost.begin() + steps), next(steps);
  std::vector<std::int16_t> cameFrom(std::size_t(kTurns) * VesselOutline::kRays * steps);
  for (int n = 1; n < kTurns * VesselOutline::kRays; ++n) {
    for (int r = 0; r < steps; ++r) {
      int best = r;
      double least = std::numeric_limits<double>::max();
      const auto [most, stiffness] = bends[r];
      for (int from = std::max(0, r - most); from <= std::min(steps - 1, r + most); ++from) {
        const double way = cost[from] + stiffness * (r - from) * (r - from);
        if (way < least) least = way, best = from;
      }
      next[r] = least + wall.at(n % VesselOutline::kRays, r);
      cameFrom[std::size_t(n) * steps + r] = static_cast<std::int16_t>(best);
    }
    cost.swap(next);
  }
  Radii radii{};
  int r = static_cast<int>(std::ranges::min_element(cost) - cost.begin());
  for (int n = kTurns * VesselOutline::kRays - 1; n >= VesselOutline::kRays / 2; --n) {
    if (n < VesselOutline::kRays + VesselOutline::kRays / 2) radii[n % VesselOutline::kRays] = wall.step_mm * (r + 1);
    r = cameFrom[std::size_t(n) * steps + r];
  }
  return radii;
}

std::vector<Radii> likeNeighbors(const std::vector<VesselOutline>& sections, int reach) {
  std::vector<Radii> expected(sections.size());
  const int count = static_cast<int>(sections.size());
  std::vector<double> radii;
  for (int n = 0; n < count; ++n)
    for (int ray = 0; ray < VesselOutline::kRays; ++ray) {
      radii.clear();
      for (int m = std::max(0, n - reach); m <= std::min(count - 1, n + reach); ++m)
        radii.push_back(sections[m].radius_mm[ray]);
      std::ranges::nth_element(radii, radii.begin() + std::ptrdiff_t(radii.size() / 2));
      expected[n][ray] = radii[radii.size() / 2];
    }
  return expected;
}

}  // namespace insonate::segmentation
