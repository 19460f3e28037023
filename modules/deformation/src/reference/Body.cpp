#include "reference/Body.h"

#include "elastic/Struts.h"
#include "reference/Equilibrium.h"

#include <algorithm>
#include <cmath>

namespace insonate::reference {
namespace {

constexpr double kShut_kPa = 20;       // of a closed lumen
constexpr double kMaxPrestress = 0.8;  // of mu: a cell under a pressure above its stiffness has no stable shape

/// Integral of the gradients of the corners' shape functions over the cell, by four points.
Eigen::Matrix4d laplacian(const Cell& cell, const Vector& rest) {
  const double g = 1 / std::sqrt(3.0);
  constexpr int kR[4] = {-1, 1, 1, -1}, kS[4] = {-1, -1, 1, 1};
  Eigen::Matrix4d sum = Eigen::Matrix4d::Zero();
  for (int point = 0; point < 4; ++point) {
    Eigen::Matrix<double, 4, 2> byUnit;
    Eigen::Matrix2d jacobian = Eigen::Matrix2d::Zero();
    for (int a = 0; a < 4; ++a) {
      byUnit(a, 0) = 0.25 * kR[a] * (1 + kS[a] * kS[point] * g);
      byUnit(a, 1) = 0.25 * kS[a] * (1 + kR[a] * kR[point] * g);
      jacobian += rest.segment<2>(2 * cell.node[a]) * byUnit.row(a);
    }
    const Eigen::Matrix<double, 4, 2> byPlace = byUnit * jacobian.inverse();
    sum += jacobian.determinant() * byPlace * byPlace.transpose();
  }
  return sum;
}

/// Stress with which the rest geometry balances the blood: that of a linear solution, as an initial stress (second
/// Piola-Kirchhoff), which is in equilibrium. The error of the cell means is a dead load.
void prestress(Body& body, const BloodPressure& blood) {
  const Load load{.blood = blood};
  const Vector displacement = Equilibrium(body).step(load);
  for (Cell& cell : body.cells) {
    const Eigen::Matrix<double, 8, 1> byArea = areaGradient(cell, body.rest) / cell.area;
    Eigen::Matrix2d gradient = Eigen::Matrix2d::Zero();
    for (int a = 0; a < 4; ++a)
      gradient += displacement.segment<2>(2 * cell.node[a]) * byArea.segment<2>(2 * a).transpose();
    Eigen::Matrix2d stress = cell.mu * (gradient + gradient.transpose());
    stress *= std::min(1.0, kMaxPrestress * cell.mu / std::max(stress.cwiseAbs().maxCoeff(), 1e-12));
    cell.initial += (cell.bulk - cell.mu) * gradient.trace();
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b < 4; ++b)
        cell.spring(a, b) += cell.area * byArea.segment<2>(2 * a).dot(stress * byArea.segment<2>(2 * b));
  }
  body.dead = gradientOf(body, body.rest, load);
  for (int k = 0; k < body.dead.size(); ++k)
    if (body.fixed[k]) body.dead[k] = 0;
}

std::vector<Strut> makeStruts(const Body& body) {
  std::vector<Strut> struts;
  const auto blood = [&](int column, int row) {
    const Cell& cell = body.cells[body.cellAt(column, row)];
    return std::max(cell.artery, cell.vein);
  };
  const auto add = [&](int from, int to, int axis, double share) {
    const double length = body.rest[2 * to + axis] - body.rest[2 * from + axis];
    if (share > 0.25)
      struts.push_back({from, to, axis, elastic::Struts::kLeft * length, share * elastic::Struts::kStiffness_kPa});
  };
  for (int j = 1; j + 1 < body.rows; ++j)
    for (int i = 1; i + 1 < body.columns; ++i) {
      const int n = j * body.columns + i;
      add(n, n + body.columns, 1, (blood(i, j) + blood(i - 1, j)) / 2);
      add(n, n + 1, 0, (blood(i, j) + blood(i, j - 1)) / 2);
    }
  return struts;
}

}  // namespace

Body makeGrid(int columns, int rows, const Vector& rest, const std::vector<double>& mu,
              const std::vector<double>& bulk) {
  Body body;
  body.columns = columns;
  body.rows = rows;
  body.rest = rest;
  body.dead = Vector::Zero(rest.size());
  body.fixed.assign(rest.size(), 0);
  for (int j = 0; j + 1 < rows; ++j)
    for (int i = 0; i + 1 < columns; ++i) {
      const int n = j * columns + i;
      Cell cell;
      cell.node = {n, n + 1, n + 1 + columns, n + columns};
      cell.area = areaOf(cell, rest);
      cell.mu = mu[body.cells.size()];
      cell.bulk = bulk[body.cells.size()];
      cell.spring = cell.mu * laplacian(cell, rest);
      cell.initial = -cell.mu;
      body.cells.push_back(cell);
    }
  return body;
}

Body makeBody(const elastic::Mesh& mesh, const elastic::Materials& materials, const BloodPressure& atRest) {
  const int columns = mesh.columns(), rows = mesh.rows();
  Vector rest(2 * columns * rows);
  for (int n = 0; n < columns * rows; ++n) {
    rest[2 * n] = mesh.rest().x[n];
    rest[2 * n + 1] = mesh.rest().z[n];
  }
  std::vector<double> mu, bulk;
  for (int j = 0; j + 1 < rows; ++j)
    for (int i = 0; i + 1 < columns; ++i) {
      mu.push_back(materials.mu[std::size_t(j) * columns + i]);
      bulk.push_back(materials.bulk[std::size_t(j) * columns + i]);
    }
  Body body = makeGrid(columns, rows, rest, mu, bulk);
  for (int k = 0; k < rest.size(); ++k) body.fixed[k] = materials.fixed[k / 2];
  for (Cell& cell : body.cells) {
    cell.artery = materials.arteryBlood[cell.node[0]];
    cell.vein = materials.veinBlood[cell.node[0]];
    const bool gas = elastic::Materials::isGas(static_cast<float>(cell.mu));
    cell.shut = kShut_kPa * (gas ? 1 : std::max(cell.artery, cell.vein));
    const elastic::Collagen& collagen = cell.artery > cell.vein ? elastic::kArteryCollagen : elastic::kVeinCollagen;
    cell.full = collagen.modulus_kPa * std::max(cell.artery, cell.vein), cell.fullAbove = collagen.above;
  }
  body.struts = makeStruts(body);
  if (!materials.anyBlood) return body;
  for (Cell& cell : body.cells) cell.bulk += materials.hoop[cell.node[0]];  // blood resists changes of area
  prestress(body, atRest);
  for (Cell& cell : body.cells) {
    cell.hoop = materials.hoop[cell.node[0]];
    cell.bulk -= cell.hoop;
  }
  return body;
}

}  // namespace insonate::reference
