#pragma once

#include "elastic/GridMatrix.h"

#include <array>
#include <vector>

namespace insonate::elastic {

/// Positions of a grid's nodes, mm in the probe frame; padded for whole SIMD vectors.
struct Nodes {
  std::vector<float> x, z;
  void resize(std::size_t nodes) {
    x.assign(nodes + GridMatrix::kPadding, 0.0f);
    z.assign(nodes + GridMatrix::kPadding, 0.0f);
  }
};

/// Four-node cells of a grid, in plane strain. Cell n has the nodes n, n+1, n+1+columns and n+columns; cells of the
/// last column do not exist and hold zeros. The energy of a cell with the corners x_a and the area A is
///
///   W = 1/2 sum m_ab x_a.x_b + base A + bulk/2 A0 (J-1)^2 + hoop/2 A0 (J-1)^2 if J > 1
///     + shut/2 A0 (J-Jmin)^2 if J < Jmin + full/3 A0 (J-Jfull)^3 if J > Jfull,   J = A/A0, A0 = A at rest.
///
/// Since J is a mean over the cell, nearly incompressible cells do not lock. L is the Laplacian in the rest geometry.
/// With m = mu L and base = -mu, W is the compressible neo-Hookean energy mu/2 (|F|^2-2) - mu (J-1) + bulk/2 (J-1)^2,
/// bulk = lambda + mu. A prestress S is added to m; the pressure p of blood is subtracted from base.
struct Elements {
  static constexpr float kShutBelow = 0.1f;  ///< Jmin: relative area at which a lumen is closed

  int columns = 0, rows = 0;
  /// Coefficients m_ab of the energy W of each cell, upper triangle, kPa: 00 01 02 03 11 12 13 22 23 33.
  std::array<std::vector<float>, 10> m;
  std::vector<float> area;                              ///< undeformed area A0 of each cell, mm2
  std::vector<float> mu, bulk, hoop, shut, full, base;  ///< moduli of each cell in the energy W, kPa
  std::vector<float> fullAbove;  ///< Jfull of each cell: relative area from which a vessel's wall resists
  std::vector<float> guarded;    ///< above 0: allowedShare() limits the Newton step for the sake of this cell
  /// Pressure of each cell, the factor of the area's second derivative in the tangent. The pressure is treated as an
  /// unknown that changes linearly with each step (mixed Newton). If the pressure were computed from the present area,
  /// steps would overshoot.
  std::vector<float> carried;

  void resize(int c, int r);
  std::size_t count() const { return std::size_t(columns) * (rows - 1); }
};

/// Computes m = mu L and A0 of each element from the undeformed mesh, where L is the Laplacian and mu the shear
/// modulus.
void shapeElements(const Nodes& rest, Elements& elements);

/// Adds each cell's tangent stiffness to `matrix` and the negative gradient of its energy to `force` ([2 * node +
/// axis]). If `caution` is above 0, pressures in the tangent are limited to mu, and m is multiplied by 1 + caution. The
/// cells' matrices are then positive semidefinite, which allows large steps from the beginning, but the steps oscillate
/// close to the solution.
void assemble(const Elements& elements, const Nodes& at, float caution, GridMatrix& matrix, std::vector<float>& force);

/// Returns the largest share of `step` ([2 * node + axis]), at most 1, by which no guarded cell loses more than 60 % of
/// its area.
float allowedShare(const Elements& elements, const Nodes& at, const std::vector<float>& step);

/// Moves the nodes by `share` of the step, and updates the carried pressures.
void advance(Elements& elements, Nodes& at, const std::vector<float>& step, float share);

}  // namespace insonate::elastic
