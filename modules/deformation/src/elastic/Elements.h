#pragma once

#include "elastic/GridMatrix.h"

#include <array>
#include <vector>

namespace insonate::elastic {

/// Positions of a grid's nodes, mm in the probe frame; padded for whole vectors.
struct Nodes {
  std::vector<float> x, z;
  void resize(std::size_t nodes) {
    x.assign(nodes + GridMatrix::kPadding, 0.0f);
    z.assign(nodes + GridMatrix::kPadding, 0.0f);
  }
};

/// Four-node cells of a grid, in plane strain. Cell n lies between nodes n, n+1, n+1+columns and n+columns; those of
/// the last column do not exist and hold zeros. Energy, with positions x_a of the corners:
///
///   W = 1/2 sum m_ab x_a.x_b + base A + bulk/2 A0 (J-1)^2 + hoop/2 A0 (J-1)^2 where J > 1
///     + shut/2 A0 (J-Jmin)^2 where J < Jmin,   J = A/A0,
///
/// A the area by the corners (so that the dilatation is a mean over the cell, which does not lock). With m = mu L (L
/// the Laplacian in the rest geometry) and base = -mu it is the compressible neo-Hookean mu/2 (|F|^2-2) - mu (J-1) +
/// bulk/2 (J-1)^2, bulk = lambda + mu. A prestress S adds to m, blood of pressure p takes p from base.
struct Elements {
  static constexpr float kShutBelow = 0.1f;  ///< Jmin, where a lumen is closed

  int columns = 0, rows = 0;
  std::array<std::vector<float>, 10> m;           ///< kPa: 00 01 02 03 11 12 13 22 23 33
  std::vector<float> area;                        ///< A0, mm2
  std::vector<float> mu, bulk, hoop, shut, base;  ///< kPa
  std::vector<float> guarded;                     ///< above 0: allowedShare() looks after the cell
  /// Coefficient of the area's second derivative in the tangent: the pressure as an unknown of its own, which follows
  /// the last step linearly (mixed Newton). With the pressure of the present area, steps overshoot.
  std::vector<float> carried;

  void resize(int c, int r);
  std::size_t count() const { return std::size_t(columns) * (rows - 1); }
};

/// Computes L and A0 of each element from the undeformed mesh; its stiffness is m = mu L with the shear modulus mu.
void shapeElements(const Nodes& rest, Elements& elements);

/// Adds every cell's tangent to `matrix` and the negative gradient of the energy to `force` ([2 * node + axis]). With
/// `caution` above 0, pressures count up to mu in the tangent and m counts 1 + caution times: cells are then positive
/// semidefinite, and steps need no small start, but close to the solution they go to and fro.
void assemble(const Elements& elements, const Nodes& at, float caution, GridMatrix& matrix, std::vector<float>& force);

/// The share of `step` ([2 * node + axis]) that can be gone until a cell has lost 60 % of its area; at most 1.
float allowedShare(const Elements& elements, const Nodes& at, const std::vector<float>& step);

/// Applies `share` of the step: moves the nodes, and the carried pressures with them.
void advance(Elements& elements, Nodes& at, const std::vector<float>& step, float share);

}  // namespace insonate::elastic
