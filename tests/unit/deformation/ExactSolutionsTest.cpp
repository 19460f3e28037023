#include "reference/Equilibrium.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <string>

namespace insonate::reference {
namespace {

using std::numbers::pi;

struct Moduli {
  double mu, bulk, lambda;
  Moduli(double young_kPa, double poisson)
      : mu(young_kPa / (2 * (1 + poisson))),
        bulk(mu + young_kPa * poisson / ((1 + poisson) * (1 - 2 * poisson))),
        lambda(bulk - mu) {}
};

/// Nodes by column and row.
Vector gridOf(int columns, int rows, const std::function<Eigen::Vector2d(int, int)>& place) {
  Vector rest(2 * columns * rows);
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) rest.segment<2>(2 * (j * columns + i)) = place(i, j);
  return rest;
}

Body uniformGrid(int columns, int rows, const Vector& rest, const Moduli& moduli) {
  const std::size_t cells = std::size_t(columns - 1) * (rows - 1);
  return makeGrid(columns, rows, rest, std::vector(cells, moduli.mu), std::vector(cells, moduli.bulk));
}

void fix(Body& body, int node) {
  body.fixed[2 * node] = body.fixed[2 * node + 1] = 1;
}

void fixBorder(Body& body) {
  for (int j = 0; j < body.rows; ++j)
    for (int i = 0; i < body.columns; ++i)
      if (i == 0 || j == 0 || i == body.columns - 1 || j == body.rows - 1) fix(body, j * body.columns + i);
}

void converge(Equilibrium& equilibrium, double tolerance_mm = 1e-10) {
  Load load;
  EXPECT_TRUE(equilibrium.solve(load, 0, tolerance_mm, 40).converged);
}

TEST(ExactSolutions, PatchesOfAnyShapeTakeALinearDisplacement) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> off(-0.25, 0.25);
  constexpr int kNodes = 9;
  const Vector rest =
      gridOf(kNodes, kNodes, [&](int i, int j) { return Eigen::Vector2d(i + off(random), j + off(random)); });
  for (const double poisson : {0.0, 0.3, 0.499}) {
    Eigen::Matrix2d gradient;
    gradient << 1.15, 0.3, -0.1, 0.8;
    Body body = uniformGrid(kNodes, kNodes, rest, Moduli(10, poisson));
    fixBorder(body);
    Equilibrium equilibrium(body);
    for (int n = 0; n < body.nodes(); ++n)
      if (body.fixed[2 * n]) equilibrium.state.at.segment<2>(2 * n) = gradient * rest.segment<2>(2 * n);
    converge(equilibrium);
    double worst = 0;
    for (int n = 0; n < body.nodes(); ++n)
      worst = std::max(
          worst, (equilibrium.state.at.segment<2>(2 * n) - gradient * rest.segment<2>(2 * n)).cwiseAbs().maxCoeff());
    EXPECT_LT(worst, 1e-8) << poisson;
  }
}

/// Free sides, smooth plates: sigma_xx = 0. F = diag(a, b) with mu a - mu b + bulk (a b - 1) b = 0.
TEST(ExactSolutions, UniformStrainBetweenSmoothPlates) {
  const Moduli m(10, 0.45);
  constexpr double kPressed = 0.7;
  double a = 1;
  for (int k = 0; k < 50; ++k)
    a -= (m.mu * (a - kPressed) + m.bulk * (a * kPressed - 1) * kPressed) / (m.mu + m.bulk * kPressed * kPressed);
  constexpr int kColumns = 9, kRows = 7;
  const Vector rest = gridOf(kColumns, kRows, [](int i, int j) { return Eigen::Vector2d(i, j); });
  Body body = uniformGrid(kColumns, kRows, rest, m);
  for (int i = 0; i < kColumns; ++i) body.fixed[2 * i + 1] = body.fixed[2 * ((kRows - 1) * kColumns + i) + 1] = 1;
  for (int j = 0; j < kRows; ++j) body.fixed[2 * j * kColumns] = 1;
  Equilibrium equilibrium(body);
  for (int n = 0; n < body.nodes(); ++n)
    equilibrium.state.at[2 * n + 1] = (kRows - 1) - kPressed * (kRows - 1 - rest[2 * n + 1]);
  converge(equilibrium);
  for (int j = 0; j < kRows; ++j)
    EXPECT_NEAR(equilibrium.state.at[2 * (j * kColumns + kColumns - 1)], a * (kColumns - 1), 1e-8) << j;
  const Vector gradient = gradientOf(body, equilibrium.state.at, {});
  double force = 0;
  for (int i = 0; i < kColumns; ++i) force += gradient[2 * i + 1];
  const double stress = m.mu * kPressed - m.mu * a + m.bulk * (a * kPressed - 1) * a;
  EXPECT_NEAR(force, -stress * (kColumns - 1), 1e-7);
}

/// Held at the sides, a layer is pressed together by p / (lambda + 2 mu) of its height, however far.
TEST(ExactSolutions, LayeredColumnsAreSpringsInSeries) {
  const Moduli layers[] = {Moduli(100, 0.49), Moduli(4, 0.45), Moduli(25, 0.3)};
  constexpr int kColumns = 4, kRows = 10;
  const Vector rest = gridOf(kColumns, kRows, [](int i, int j) { return Eigen::Vector2d(i, j + 0.02 * j * j); });
  std::vector<double> mu, bulk;
  double compliance = 0;
  for (int j = 0; j + 1 < kRows; ++j) {
    const Moduli& m = layers[j / 3];
    compliance += (rest[2 * kColumns * (j + 1) + 1] - rest[2 * kColumns * j + 1]) / (m.lambda + 2 * m.mu);
    mu.insert(mu.end(), kColumns - 1, m.mu);
    bulk.insert(bulk.end(), kColumns - 1, m.bulk);
  }
  Body body = makeGrid(kColumns, kRows, rest, mu, bulk);
  for (int n = 0; n < body.nodes(); ++n)
    body.fixed[2 * n] = 1, body.fixed[2 * n + 1] = n < kColumns || n >= (kRows - 1) * kColumns;
  Equilibrium equilibrium(body);
  constexpr double kPress_mm = 2;
  for (int i = 0; i < kColumns; ++i) equilibrium.state.at[2 * i + 1] += kPress_mm;
  converge(equilibrium);
  double expected = kPress_mm;
  for (int j = 0; j + 1 < kRows; ++j) {
    EXPECT_NEAR(equilibrium.state.at[2 * kColumns * j + 1] - rest[2 * kColumns * j + 1], expected, 1e-8) << j;
    const Moduli& m = layers[j / 3];
    expected -= kPress_mm / compliance * (rest[2 * kColumns * (j + 1) + 1] - rest[2 * kColumns * j + 1]) /
                (m.lambda + 2 * m.mu);
  }
}

/// Displacement along the radius u = A r + B / r in each of two layers, tension 2 (lambda + mu) A - 2 mu B / r^2
/// (Lame): pressure inside, nothing moves outside.
TEST(ExactSolutions, ThickWalledCylinderUnderPressure) {
  constexpr double kInner = 3, kMiddle = 4, kOuter = 20, kPressure = 1e-4;
  const Moduli wall(200, 0.49), tissue(10, 0.49);
  Eigen::Matrix4d system;
  const auto tension = [](const Moduli& m, double r) {
    return Eigen::RowVector2d(2 * (m.lambda + m.mu), -2 * m.mu / (r * r));
  };
  system << tension(wall, kInner), 0, 0,                  //
      kMiddle, 1 / kMiddle, -kMiddle, -1 / kMiddle,       //
      tension(wall, kMiddle), -tension(tissue, kMiddle),  //
      0, 0, kOuter, 1 / kOuter;
  const Eigen::Vector4d c = system.partialPivLu().solve(Eigen::Vector4d(-kPressure, 0, 0, 0));

  double before = 0;
  for (const int fine : {1, 2, 4}) {
    const int columns = 12 * fine + 1, inWall = 4 * fine, rows = inWall + 16 * fine + 1;
    const auto radius = [&](int j) {
      return j <= inWall ? kInner + (kMiddle - kInner) * j / inWall
                         : kMiddle * std::pow(kOuter / kMiddle, double(j - inWall) / (rows - 1 - inWall));
    };
    const Vector rest = gridOf(columns, rows, [&](int i, int j) {
      const double angle = pi / 2 * (1 - double(i) / (columns - 1));  // cells the right way round
      return Eigen::Vector2d(radius(j) * std::cos(angle), radius(j) * std::sin(angle));
    });
    std::vector<double> mu, bulk;
    for (int j = 0; j + 1 < rows; ++j) {
      mu.insert(mu.end(), columns - 1, (j < inWall ? wall : tissue).mu);
      bulk.insert(bulk.end(), columns - 1, (j < inWall ? wall : tissue).bulk);
    }
    Body body = makeGrid(columns, rows, rest, mu, bulk);
    ASSERT_GT(body.cells[0].area, 0);
    for (int j = 0; j < rows; ++j) {
      body.fixed[2 * j * columns] = 1;                      // x = 0
      body.fixed[2 * (j * columns + columns - 1) + 1] = 1;  // z = 0
    }
    for (int i = 0; i < columns; ++i) fix(body, (rows - 1) * columns + i);
    for (int i = 0; i + 1 < columns; ++i) {  // pressure along the chords of the inner face
      const Eigen::Vector2d chord = rest.segment<2>(2 * (i + 1)) - rest.segment<2>(2 * i);
      const Eigen::Vector2d push = kPressure / 2 * Eigen::Vector2d(-chord.y(), chord.x());
      body.dead.segment<2>(2 * i) += push;
      body.dead.segment<2>(2 * (i + 1)) += push;
    }
    Equilibrium equilibrium(body);
    converge(equilibrium);
    double worst = 0;
    for (int j = 0; j < rows; ++j) {
      const int n = j * columns + columns / 2;
      const double r = radius(j), exact = j <= inWall ? c[0] * r + c[1] / r : c[2] * r + c[3] / r;
      const double moved = (equilibrium.state.at - rest).segment<2>(2 * n).dot(rest.segment<2>(2 * n)) / r;
      worst = std::max(worst, std::abs(moved - exact));
    }
    worst /= std::abs(c[0] * kInner + c[1] / kInner);
    RecordProperty("error_" + std::to_string(fine), std::to_string(worst));
    EXPECT_LT(worst, fine == 1 ? 0.05 : before / 3.2);
    before = worst;
  }
  EXPECT_LT(before, 0.002);
}

/// A displacement is chosen, the body force that goes with it applied, and the displacement found again.
class Manufactured : public testing::Test {
 protected:
  static constexpr double kSide = 8, kAmplitude = 1;
  const Moduli m{10, 0.49};

  /// Nearly keeps areas: by a stream function, kAmplitude sin^2 sin^2.
  static Eigen::Vector2d place(const Eigen::Vector2d& p) {
    const double s = std::sin(pi * p.x() / kSide), t = std::sin(pi * p.y() / kSide);
    const double s2 = std::sin(2 * pi * p.x() / kSide), t2 = std::sin(2 * pi * p.y() / kSide);
    return p + kAmplitude * pi / kSide * Eigen::Vector2d(s * s * t2, -s2 * t * t);
  }
  Eigen::Matrix2d stress(const Eigen::Vector2d& p) const {  // first Piola-Kirchhoff
    constexpr double h = 1e-4;
    Eigen::Matrix2d f;
    for (int axis = 0; axis < 2; ++axis) {
      const Eigen::Vector2d e = h * Eigen::Vector2d::Unit(axis);
      f.col(axis) = (place(p + e) - place(p - e)) / (2 * h);
    }
    Eigen::Matrix2d cofactor;
    cofactor << f(1, 1), -f(1, 0), -f(0, 1), f(0, 0);
    return m.mu * f + (-m.mu + m.bulk * (f.determinant() - 1)) * cofactor;
  }
  Eigen::Vector2d bodyForce(const Eigen::Vector2d& p) const {
    constexpr double h = 1e-3;
    Eigen::Vector2d force = Eigen::Vector2d::Zero();
    for (int axis = 0; axis < 2; ++axis) {
      const Eigen::Vector2d e = h * Eigen::Vector2d::Unit(axis);
      force -= (stress(p + e).col(axis) - stress(p - e).col(axis)) / (2 * h);
    }
    return force;
  }

  /// RMS over the nodes.
  double errorOf(double mesh_mm) const {
    const int nodes = static_cast<int>(std::lround(kSide / mesh_mm)) + 1;
    const Vector rest = gridOf(nodes, nodes, [&](int i, int j) { return Eigen::Vector2d(i * mesh_mm, j * mesh_mm); });
    Body body = uniformGrid(nodes, nodes, rest, m);
    fixBorder(body);
    const double g = 1 / std::sqrt(3.0);
    for (const Cell& cell : body.cells)
      for (const double r : {-g, g})
        for (const double s : {-g, g}) {
          const double shape[] = {(1 - r) * (1 - s), (1 + r) * (1 - s), (1 + r) * (1 + s), (1 - r) * (1 + s)};
          Eigen::Vector2d p = Eigen::Vector2d::Zero();
          for (int a = 0; a < 4; ++a) p += shape[a] / 4 * rest.segment<2>(2 * cell.node[a]);
          const Eigen::Vector2d force = bodyForce(p) * cell.area / 4;
          for (int a = 0; a < 4; ++a) body.dead.segment<2>(2 * cell.node[a]) += shape[a] / 4 * force;
        }
    Equilibrium equilibrium(body);
    for (int n = 0; n < body.nodes(); ++n)
      if (body.fixed[2 * n]) equilibrium.state.at.segment<2>(2 * n) = place(rest.segment<2>(2 * n));
    converge(equilibrium, 1e-8);
    double sum = 0;
    for (int n = 0; n < body.nodes(); ++n)
      sum += (equilibrium.state.at.segment<2>(2 * n) - place(rest.segment<2>(2 * n))).squaredNorm();
    return std::sqrt(sum / body.nodes());
  }
};

TEST_F(Manufactured, DisplacementConvergesWithTheSquareOfTheMesh) {
  const double coarse = errorOf(0.5), middle = errorOf(0.25), fine = errorOf(0.125);
  RecordProperty("error_500um", std::to_string(coarse));
  RecordProperty("error_250um", std::to_string(middle));
  RecordProperty("error_125um", std::to_string(fine));
  EXPECT_GT(std::log2(coarse / middle), 1.8);
  EXPECT_GT(std::log2(middle / fine), 1.8);
  EXPECT_LT(fine, 0.002);
}

}  // namespace
}  // namespace insonate::reference
