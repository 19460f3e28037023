#pragma once

#include "reference/Body.h"

namespace insonate::reference {

/// Loads on a body besides its own stresses.
struct Load {
  BloodPressure blood;
  const FaceProfile* face = nullptr;  ///< none: nothing presses
  double shift_mm = 0;                ///< of the face along z
  /// Positions at which nodes meet the face's profile: at their x here, even while they move on. Nodes that followed
  /// the profile within one solve would touch the face's edge and come off it by turns. Empty: the positions at the
  /// beginning of a solve.
  Vector meeting = Vector();
  bool sticking = false;
};

/// Area between the corners of a cell, from its diagonals.
double areaOf(const Cell& cell, const Vector& at);
/// Derivative of the area by x and z of each corner, [2 * corner + axis].
Eigen::Matrix<double, 8, 1> areaGradient(const Cell& cell, const Vector& at);

/// dW/dA: kPa, above 0 where the cell pulls itself together; and its derivative by the area.
struct Tension {
  double value = 0, slope = 0;
};
Tension tensionOf(const Cell& cell, const BloodPressure& blood, double area_mm2);

/// Energy of cells, struts and the face's springs, less the work of dead loads; kPa mm2, or microjoule per millimeter
/// of thickness.
double energyOf(const Body& body, const Vector& at, const Load& load);

/// Its derivative by the positions: what holds fixed nodes, and zero elsewhere in equilibrium.
Vector gradientOf(const Body& body, const Vector& at, const Load& load);

/// Force of the face, kPa mm.
double faceForceOf(const Body& body, const Vector& at, const Load& load);

/// Contact of a node of the top row: the stiffness of its spring, and its indentation, mm.
struct Touch {
  double stiffness_kPa = 0, depth_mm = 0;
};
Touch touchOf(const Body& body, const Vector& at, const Load& load, int column);

/// Entries of the tangent; `tension` is each cell's as an unknown of its own (see Equilibrium). `most` limits it to
/// this multiple of the cell's mu.
std::vector<Eigen::Triplet<double>> tangentOf(const Body& body, const Vector& at, const Load& load,
                                              const std::vector<double>& tension, double most);

}  // namespace insonate::reference
