#pragma once

#include "reference/Body.h"

namespace insonate::reference {

/// Loads on a body, other than its own stresses.
struct Load {
  BloodPressure blood;
  const FaceProfile* face = nullptr;  ///< the probe's face; null if no face presses
  double shift_mm = 0;                ///< shift of the face along z
  /// Node positions whose x determines where each node meets the face's profile; they are not updated while the nodes
  /// move. Nodes that followed the profile within one solution would alternately touch the face's edge and lose
  /// contact. Empty for the positions at the beginning of the solution.
  Vector meeting = Vector();
  bool sticking = false;
};

/// Returns the area of a cell, from its diagonals.
double areaOf(const Cell& cell, const Vector& at);
/// Returns the derivative of the area with respect to x and z of each corner, [2 * corner + axis].
Eigen::Matrix<double, 8, 1> areaGradient(const Cell& cell, const Vector& at);

/// Tension of a cell, dW/dA in kPa, above 0 if the cell contracts, and the derivative of the tension with respect to
/// the area.
struct Tension {
  double value = 0, slope = 0;
};
Tension tensionOf(const Cell& cell, const BloodPressure& blood, double area_mm2);

/// Returns the energy of cells, struts and the face's springs minus the work of dead loads, in kPa mm2 (microjoule per
/// millimeter of thickness).
double energyOf(const Body& body, const Vector& at, const Load& load);

/// Returns the derivative of energyOf() with respect to the positions. In equilibrium the derivative is the reaction
/// force at fixed nodes, and zero at all others.
Vector gradientOf(const Body& body, const Vector& at, const Load& load);

/// Returns the force of the face per millimeter of footprint, kPa mm.
double faceForceOf(const Body& body, const Vector& at, const Load& load);

/// Contact of a node of the top row: the stiffness of its spring, and its indentation, mm.
struct Touch {
  double stiffness_kPa = 0, depth_mm = 0;
};
Touch touchOf(const Body& body, const Vector& at, const Load& load, int column);

/// Returns the entries of the tangent stiffness matrix. `tension` holds each cell's tension, which is treated as an
/// unknown (see Equilibrium); its absolute value is limited to `most` times the cell's mu.
std::vector<Eigen::Triplet<double>> tangentOf(const Body& body, const Vector& at, const Load& load,
                                              const std::vector<double>& tension, double most);

}  // namespace insonate::reference
