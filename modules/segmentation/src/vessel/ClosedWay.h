#pragma once

#include <insonate/segmentation/VesselTracking.h>

#include <array>
#include <functional>
#include <vector>

namespace insonate::segmentation {

/// A radius for each ray of a section.
using Radii = std::array<double, VesselOutline::kRays>;

/// Cost of a wall at each radius of each ray: wall r lies at step_mm (r + 1).
struct RadialCost {
  RadialCost(int count, double apart_mm)
      : steps(count), step_mm(apart_mm), cost(std::size_t(VesselOutline::kRays) * std::size_t(count)) {}
  double& at(int ray, int r) { return cost[std::size_t(ray) * std::size_t(steps) + std::size_t(r)]; }

  int steps;
  double step_mm;
  std::vector<double> cost;
};

/// Motion of a wall from one ray to the next: at most this many steps; n steps cost stiffness n^2.
struct Bend {
  int most = 3;
  double stiffness = 0;
};

/// The cheapest closed way around, where wall r bends from the ray before as `bendAt(r)` says; with `expected`, radii
/// that are not like it cost more, too (dynamic programming over two turns, of which the middle is free of where it
/// began).
Radii closedWay(RadialCost cost, const std::function<Bend(int)>& bendAt, const Radii* expected);

/// For each ray, the median of its radii in `reach` sections to both sides.
std::vector<Radii> likeNeighbours(const std::vector<VesselOutline>& sections, int reach);

}  // namespace insonate::segmentation
