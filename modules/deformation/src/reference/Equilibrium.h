#pragma once

#include "reference/Equations.h"

#include <Eigen/SparseCholesky>

namespace insonate::reference {

/// Equilibrium of a body by Newton steps in double precision, the tension of each cell an unknown of its own that is
/// eliminated cell by cell: with it, a tangent that is linear in the positions overshoots less where tissue is nearly
/// incompressible (mean dilatation as a three-field method: J. C. Simo and R. L. Taylor, Comput. Methods Appl. Mech.
/// Eng. 85, 1991).
class Equilibrium {
 public:
  explicit Equilibrium(const Body& body);

  struct State {
    Vector at;
    std::vector<double> tension;  ///< of each cell
    double shift_mm = 0;          ///< of the face, found where a force is asked for
  };
  State state;  ///< where the next solve starts; fixed nodes stay where it has them

  struct Outcome {
    bool converged = false;  ///< the last whole step moved nothing by more than the tolerance
    int iterations = 0;
    double missed_mm = 0;  ///< of the face's height where touching nodes have moved to, and where they met it
  };
  /// Solves at load.shift_mm; or, with force_kPa_mm above 0, at the shift at which the face presses with it. Leaves in
  /// `load` the positions at which nodes met the face, and its shift.
  Outcome solve(Load& load, double force_kPa_mm, double tolerance_mm, int mostIterations);

  /// A whole Newton step from the present state, not taken. Nothing where the tangent is not positive definite.
  Vector step(const Load& load);

  /// Every cell that is not lumen has kept the right way round.
  bool inOrder() const;

 private:
  bool factor(const Load& load, bool cautious);
  Vector solveWith(const Vector& right) const;
  double followForce(const Load& load, double wanted_kPa_mm, Vector& step) const;
  double allowedShare(const Vector& step) const;
  double missedBy(const Load& load) const;
  void advance(const Load& load, const Vector& step);

  const Body& body_;
  std::vector<int> unknown_;  ///< [2 * node + axis]: in the order of elimination; -1 where fixed
  int unknowns_ = 0;
  Eigen::SimplicialLDLT<Matrix, Eigen::Lower, Eigen::NaturalOrdering<int>> factor_;
  bool analysed_ = false;
};

}  // namespace insonate::reference
