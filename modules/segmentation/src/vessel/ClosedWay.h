#pragma once

#include <insonate/segmentation/VesselTracking.h>

#include <array>
#include <functional>
#include <vector>

namespace insonate::segmentation {

/// Radius of an outline on each ray of a section.
using Radii = std::array<double, VesselOutline::kRays>;

/// Cost of placing the wall at each radius of each ray: index r is the radius step_mm (r + 1).
struct RadialCost {
  RadialCost(int count, double apart_mm)
      : steps(count), step_mm(apart_mm), cost(std::size_t(VesselOutline::kRays) * std::size_t(count)) {}
  double& at(int ray, int r) { return cost[std::size_t(ray) * std::size_t(steps) + std::size_t(r)]; }

  int steps;
  double step_mm;
  std::vector<double> cost;
};

/// Limits of the wall's change of radius from one ray to the next: at most `most` steps; a change of n steps costs
/// stiffness n^2.
struct Bend {
  int most = 3;
  double stiffness = 0;
};

/// Returns the closed outline of minimum cost. `bendAt(r)` limits the change of radius from the previous ray to index
/// r. If `expected` is given, deviations from `expected` cost more, too. Dynamic programming over two turns around the
/// center; the result is one turn from the middle of these two, which does not depend on the ray at which the search
/// starts.
Radii closedWay(RadialCost cost, const std::function<Bend(int)>& bendAt, const Radii* expected);

/// Returns, for each section and ray, the median of the radii of the section and `reach` sections on both sides.
std::vector<Radii> likeNeighbors(const std::vector<VesselOutline>& sections, int reach);

}  // namespace insonate::segmentation
