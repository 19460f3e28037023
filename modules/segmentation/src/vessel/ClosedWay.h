#pragma once

#include <insonate/segmentation/VesselTracking.h>

#include <array>
#include <vector>

namespace insonate::segmentation {

/// A radius for each ray of a section.
using Radii = std::array<double, VesselOutline::kRays>;

/// What a wall at each radius of each ray costs: wall r lies at step_mm (r + 1).
struct RadialCost {
  RadialCost(int count, double apart_mm)
      : steps(count), step_mm(apart_mm), cost(std::size_t(VesselOutline::kRays) * std::size_t(count)) {}
  double& at(int ray, int r) { return cost[std::size_t(ray) * std::size_t(steps) + std::size_t(r)]; }

  int steps;
  double step_mm;
  std::vector<double> cost;
};

/// The cheapest closed way around, where a wall that moves by n steps from a ray to the next costs bend n^2 more; with
/// `expected`, radii that are not like it cost more, too (dynamic programming over two turns, of which the middle is
/// free of where it began).
Radii closedWay(RadialCost cost, double bend, const Radii* expected);

/// Of each ray, the median of its radii in the sections around.
std::vector<Radii> expectedRadii(const std::vector<VesselOutline>& sections);

}  // namespace insonate::segmentation
