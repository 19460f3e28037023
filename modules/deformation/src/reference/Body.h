#pragma once

#include "elastic/Materials.h"

#include <insonate/deformation/FaceProfile.h>

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <array>
#include <vector>

namespace insonate::reference {

/// Values by node and axis, [2 * node + axis]: positions x and z, mm in the probe frame, or loads, kPa mm.
using Vector = Eigen::VectorXd;
using Matrix = Eigen::SparseMatrix<double>;  ///< symmetric matrix; only the lower triangle is stored

/// A four-node cell in plane strain. With the positions x_a of its corners, the area A and J = A/A0, its energy is
///
///   W = 1/2 sum spring_ab x_a.x_b + (initial - blood) A + bulk/2 A0 (J-1)^2 + shut/2 A0 min(J - kShutBelow, 0)^2
///     + hoop/2 A0 max(J-1, 0)^2 + full/3 A0 max(J - fullAbove, 0)^3
///
/// With spring = mu L (L is the Laplacian at rest) and initial = -mu, W is mu/2 (|F|^2-2) - mu (J-1) + bulk/2 (J-1)^2.
/// Prestress is added to spring and initial; `blood` is the pressure of the blood.
struct Cell {
  static constexpr double kShutBelow = 0.1;

  std::array<int, 4> node{};  ///< the cell's corner nodes, in order around the cell
  double area = 0;            ///< undeformed area A0, mm2
  Eigen::Matrix4d spring = Eigen::Matrix4d::Zero();
  double mu = 0, bulk = 0, hoop = 0, shut = 0, full = 0, initial = 0;  ///< moduli in the cell's energy W, kPa
  double fullAbove = 0;
  double artery = 0, vein = 0;  ///< shares of the cell's area inside arterial and venous lumens
};

/// A one-sided spring: it pushes two nodes apart along an axis if the nodes are closer than `min_mm`.
struct Strut {
  int from = 0, to = 0, axis = 0;
  double min_mm = 0, stiffness_kPa = 0;
};

/// Tissue divided into cells on a grid of nodes, with the springs between the walls of its lumens.
struct Body {
  int columns = 0, rows = 0;
  Vector rest, dead;        ///< rest: undeformed positions of the nodes; dead: constant loads on the nodes
  std::vector<char> fixed;  ///< [2 * node + axis] true if the node does not move along the axis
  std::vector<Cell> cells;
  std::vector<Strut> struts;

  int nodes() const { return columns * rows; }
  int cellAt(int column, int row) const { return row * (columns - 1) + column; }
};

/// Makes a grid of solid tissue without fixed nodes; moduli of each cell in kPa.
Body makeGrid(int columns, int rows, const Vector& rest, const std::vector<double>& mu,
              const std::vector<double>& bulk);

/// Makes the problem that the elastic model solves, on the same mesh, prestressed so that it is in equilibrium under
/// the pressures `atRest`.
Body makeBody(const elastic::Mesh& mesh, const elastic::Materials& materials, const BloodPressure& atRest);

}  // namespace insonate::reference
