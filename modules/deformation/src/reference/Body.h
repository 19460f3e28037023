#pragma once

#include "elastic/Materials.h"

#include <insonate/deformation/FaceProfile.h>

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <array>
#include <vector>

namespace insonate::reference {

/// x and z of each node, mm in the probe frame: [2 * node + axis]. Loads, kPa mm, in the same order.
using Vector = Eigen::VectorXd;
using Matrix = Eigen::SparseMatrix<double>;  ///< lower triangle

/// A four-node cell in plane strain. With positions x_a of its corners, area A and J = A/A0 its energy is
///
///   W = 1/2 sum spring_ab x_a.x_b + (initial - blood) A + bulk/2 A0 (J-1)^2 + shut/2 A0 min(J - kShutBelow, 0)^2
///     + hoop/2 A0 max(J-1, 0)^2
///
/// With spring = mu L (L the Laplacian at rest) and initial = -mu it is mu/2 (|F|^2-2) - mu (J-1) + bulk/2 (J-1)^2.
/// Prestress adds to spring and initial; `blood` is a pressure.
struct Cell {
  static constexpr double kShutBelow = 0.1;

  std::array<int, 4> node{};  ///< round the cell
  double area = 0;            ///< A0, mm2
  Eigen::Matrix4d spring = Eigen::Matrix4d::Zero();
  double mu = 0, bulk = 0, hoop = 0, shut = 0, initial = 0;  ///< kPa
  double artery = 0, vein = 0;                               ///< shares of the cell that are lumens
};

/// Pushes two nodes apart along an axis once they are nearer than `least_mm`.
struct Strut {
  int from = 0, to = 0, axis = 0;
  double least_mm = 0, stiffness_kPa = 0;
};

/// Tissue cut into cells, on a grid of nodes.
struct Body {
  int columns = 0, rows = 0;
  Vector rest, dead;        ///< dead: loads that do not change
  std::vector<char> fixed;  ///< [2 * node + axis]
  std::vector<Cell> cells;
  std::vector<Strut> struts;

  int nodes() const { return columns * rows; }
  int cellAt(int column, int row) const { return row * (columns - 1) + column; }
};

/// A grid of solid tissue without anything that holds it; moduli of each cell, kPa.
Body makeGrid(int columns, int rows, const Vector& rest, const std::vector<double>& mu,
              const std::vector<double>& bulk);

/// The problem of the elastic model on the same mesh, prestressed so that it is in balance under `atRest`.
Body makeBody(const elastic::Mesh& mesh, const elastic::Materials& materials, const BloodPressure& atRest);

}  // namespace insonate::reference
