#include "Equilibrium.h"
#include "WireRig.h"

#include <gmock/gmock.h>

#include <numbers>

namespace insonate {
namespace {

using namespace wire;

/// A rod without walls: clamped at the origin along z, with `count` segments.
struct FreeRod {
  FreeRod(const Wire& made, double spacing_mm, int count)
      : settings{.wallStiffness_Npmm2 = 0, .tipStiffness_Npmm = 0},
        tree(test::treeOf({test::straightVein(10, 2)})),
        wire(made),
        material(wire, spacing_mm, count),
        energy(tree, wire, settings, material),
        rod(count),
        equilibrium(count, 1e-9, 500) {
    energy.setSystem(kVein);
    rod.segments = count;
    for (int j = 0; j <= count; ++j) rod.node[j] = Vector(0, 0, (count - j) * spacing_mm);
    for (double& length_mm : rod.length_mm) length_mm = spacing_mm;
  }
  WireSettings settings;
  VesselTree tree;
  Wire wire;
  RodMaterial material;
  RodEnergy energy;
  Rod rod;
  Equilibrium equilibrium;
};

TEST(Rod, DerivativesAreThoseOfTheEnergy) {
  Wire wire = loadWire("j-tip").value();
  FreeRod free(wire, 2, 5);
  free.settings = {};  // the vein touches the bent and twisted shape
  for (int j = 0; j < 5; ++j) {
    free.rod.node[j] += Vector(0.3 * (5 - j), 0.1 * j * j, -0.02 * j);
    free.rod.frame[j] = Frame(Eigen::AngleAxisd(0.15 * (5 - j), Vector(0.2, 1, 0.3).normalized())) * free.rod.frame[j];
  }
  BlockSolver equations(5);
  std::vector<BlockVector> gradient(5), left(5), right(5);
  BlockSolver unused(5);
  const auto moved = [&](int j, int axis, double by) {
    Rod rod = free.rod;
    if (axis < 3)
      rod.node[j](axis) += by;
    else
      rod.frame[j] = rod.frame[j] * Frame(Eigen::AngleAxisd(by, Vector::Unit(axis - 3)));
    return rod;
  };
  free.energy.assemble(free.rod, gradient, equations);
  constexpr double kStep = 1e-5;
  for (int j = 0; j < 5; ++j)
    for (int axis = 0; axis < 6; ++axis) {
      const Rod plus = moved(j, axis, kStep), minus = moved(j, axis, -kStep);
      const double slope = (free.energy.energy(plus) - free.energy.energy(minus)) / (2 * kStep);
      EXPECT_NEAR(gradient[j](axis), slope, 1e-4 * (1 + std::abs(slope))) << j << ' ' << axis;
      free.energy.assemble(plus, right, unused);
      free.energy.assemble(minus, left, unused);
      for (int row = 0; row < 3; ++row) {  // rotations about a turned frame are no plain coordinates
        const double here = (right[j](row) - left[j](row)) / (2 * kStep);
        EXPECT_NEAR(equations.diagonal[j](row, axis), here, 1e-3 * (1 + std::abs(here))) << j << row << axis;
        if (j == 0) continue;
        const double beside = (right[j - 1](row) - left[j - 1](row)) / (2 * kStep);
        EXPECT_NEAR(equations.beside[j - 1](row, axis), beside, 1e-3 * (1 + std::abs(beside))) << j << row << axis;
      }
      const double twice =
          (free.energy.energy(plus) - 2 * free.energy.energy(free.rod) + free.energy.energy(minus)) / (kStep * kStep);
      EXPECT_NEAR(equations.diagonal[j](axis, axis), twice, 0.02 * std::abs(twice) + 2) << j << ' ' << axis;
    }
  for (int j = 0; j + 1 < 5; ++j)
    for (int a = 3; a < 6; ++a)
      for (int b = 3; b < 6; ++b) {
        // Mixed second derivative over the rotations of neighbors.
        double sum = 0;
        constexpr double kWide = 1e-3;
        for (const int sa : {1, -1})
          for (const int sb : {1, -1}) {
            Rod rod = moved(j, a, sa * kWide);
            rod.frame[j + 1] = rod.frame[j + 1] * Frame(Eigen::AngleAxisd(sb * kWide, Vector::Unit(b - 3)));
            sum += sa * sb * free.energy.energy(rod);
          }
        EXPECT_NEAR(equations.beside[j](a, b), sum / (4 * kWide * kWide), 1e-3) << j << a << b;
      }
}

TEST(Rod, SmallLoadBendsACantileverLikeALinearBeam) {
  // w = F L^3 / (3 E I)
  constexpr double kStiffness = 100, kLength = 50, kForce = 2e-3;
  FreeRod free(test::plainWire(kStiffness), 1, 50);
  free.rod.load_N[0] = Vector(kForce, 0, 0);
  EXPECT_LT(free.equilibrium.solve(free.rod, free.energy).unbalanced_N, 1e-8);
  EXPECT_NEAR(free.rod.node[0].x(), kForce * std::pow(kLength, 3) / (3 * kStiffness), 0.002);
}

TEST(Rod, LargeLoadBendsACantileverLikeTheElastica) {
  // Tip of the elastica for F L^2 / (E I) = 1, 2, 5: Bisshopp KE, Drucker DC. Large deflection of cantilever beams.
  // Q Appl Math 1945;3(3):272-275.
  struct Case {
    double load, deflection, shortening;
  };
  for (const auto& [load, deflection, shortening] :
       {Case{1, 0.30172, 0.05643}, Case{2, 0.49346, 0.16064}, Case{5, 0.71379, 0.38763}}) {
    constexpr double kStiffness = 100, kLength = 50;
    FreeRod free(test::plainWire(kStiffness), 1, 50);
    free.rod.load_N[0] = Vector(load * kStiffness / kLength / kLength, 0, 0);
    EXPECT_LT(free.equilibrium.solve(free.rod, free.energy).unbalanced_N, 1e-8);
    EXPECT_NEAR(free.rod.node[0].x() / kLength, deflection, 1e-3) << load;
    EXPECT_NEAR(1 - free.rod.node[0].z() / kLength, shortening, 1e-3) << load;
  }
}

TEST(Rod, BucklesAtTheLoadOfEuler) {
  // pi^2 E I / (4 L^2) for a column that is free at its end.
  constexpr double kStiffness = 100, kLength = 50;
  constexpr double kEuler = std::numbers::pi * std::numbers::pi * kStiffness / (4 * kLength * kLength);
  for (const double share : {0.98, 1.02}) {
    FreeRod free(test::plainWire(kStiffness), 1, 50);
    free.rod.load_N[0] = Vector(1e-6, 0, -share * kEuler);
    free.equilibrium.solve(free.rod, free.energy);
    if (share < 1)
      EXPECT_LT(std::abs(free.rod.node[0].x()), 0.1);
    else
      EXPECT_GT(std::abs(free.rod.node[0].x()), 5);
  }
}

TEST(Rod, FreeJIsAnArcOfItsRadius) {
  Wire wire = test::plainWire(2);
  wire.sections = {{9, 2, 3, 0.5}, {60, 2, 0, 0.5}};
  FreeRod free(wire, 0.5, 40);
  free.equilibrium.solve(free.rod, free.energy);
  // The arc of 9 mm turns by 3 rad toward d1, which is x.
  EXPECT_NEAR(free.rod.node[0].x(), 3 * (1 - std::cos(3.0)), 0.03);
  EXPECT_NEAR(free.rod.node[0].z(), 11 + 3 * std::sin(3.0), 0.03);
  EXPECT_NEAR(free.rod.node[0].y(), 0, 1e-6);
  EXPECT_NEAR(free.energy.curvature_1pmm(free.rod, 5), 1.0 / 3, 1e-3);
}

TEST(Rod, FinerNodesConvergeWithTheSquareOfTheSpacing) {
  const auto deflection = [](double spacing_mm) {
    FreeRod free(test::plainWire(100), spacing_mm, static_cast<int>(std::lround(48 / spacing_mm)));
    free.rod.load_N[0] = Vector(0.1, 0, 0);
    free.equilibrium.solve(free.rod, free.energy);
    return free.rod.node[0].x();
  };
  const double finest = deflection(0.5), error2 = deflection(2) - finest, error4 = deflection(4) - finest;
  EXPECT_NEAR(error4 / error2, 4, 0.5);
}

}  // namespace
}  // namespace insonate
