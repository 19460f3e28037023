#pragma once

#include "reference/Body.h"

namespace insonate::reference {

/// What acts on a body besides its own stresses.
struct Load {
  BloodPressure blood;
  const FaceProfile* face = nullptr;  ///< none: nothing presses
  double shift_mm = 0;                ///< of the face along z
  /// Where nodes meet the face's profile: at their x here, while they move on. Nodes that followed it within one solve
  /// would touch the face's edge and come off it by turns. Empty: where they are when a solve begins.
  Vector meeting = Vector();
  bool sticking = false;
};

/// Of the corners of a cell by the diagonals.
double areaOf(const Cell& cell, const Vector& at);
/// Derivative of the area by x and z of each corner, [2 * corner + axis].
Eigen::Matrix<double, 8, 1> areaGradient(const Cell& cell, const Vector& at);

/// dW/dA: kPa, above 0 where the cell pulls itself together; and its derivative by the area.
struct Tension {
  double value = 0, slope = 0;
};
Tension tensionOf(const Cell& cell, const BloodPressure& blood, double area_mm2);

/// Of cells, struts and the face's springs, less the work of dead loads; kPa mm2, or microjoule a millimetre of
/// thickness.
double energyOf(const Body& body, const Vector& at, const Load& load);

/// Its derivative by the positions: what holds fixed nodes, and zero elsewhere in equilibrium.
Vector gradientOf(const Body& body, const Vector& at, const Load& load);

/// With which the face presses, kPa mm.
double faceForceOf(const Body& body, const Vector& at, const Load& load);

/// Where a node of the top row touches: the stiffness of its spring, and how far it has been pushed in, mm.
struct Touch {
  double stiffness_kPa = 0, depth_mm = 0;
};
Touch touchOf(const Body& body, const Vector& at, const Load& load, int column);

/// Entries of the tangent; `tension` is each cell's as an unknown of its own (see Equilibrium). `most` limits it to
/// so many times the cell's mu.
std::vector<Eigen::Triplet<double>> tangentOf(const Body& body, const Vector& at, const Load& load,
                                              const std::vector<double>& tension, double most);

}  // namespace insonate::reference
