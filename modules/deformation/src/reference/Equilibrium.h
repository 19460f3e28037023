#pragma once

#include "reference/Equations.h"

#include <Eigen/SparseCholesky>

namespace insonate::reference {

/// Equilibrium of a body by Newton steps in double precision. The tension of each cell is an additional unknown, which
/// is eliminated cell by cell. With this unknown, a Newton step overshoots less in nearly incompressible tissue (mean
/// dilatation as a three-field method: J. C. Simo and R. L. Taylor, Comput. Methods Appl. Mech. Eng. 85, 1991).
class Equilibrium {
 public:
  explicit Equilibrium(const Body& body);

  struct State {
    Vector at;
    std::vector<double> tension;  ///< tension of each cell
    double shift_mm = 0;          ///< shift of the face, determined by solve() if a force is required
  };
  State state;  ///< starting point of the next solve(); fixed nodes keep their positions of this state

  struct Outcome {
    bool converged = false;  ///< true if no node moved by more than the tolerance in the last full step
    int iterations = 0;
    /// Maximum difference between the assumed and the actual z of the face, at nodes that slid along the face.
    double missed_mm = 0;
  };
  /// Finds the equilibrium with the face at load.shift_mm or, if force_kPa_mm is above 0, at the shift at which the
  /// face presses with that force. Stores in `load` the positions at which nodes met the face, and the shift.
  Outcome solve(Load& load, double force_kPa_mm, double tolerance_mm, int maxIterations);

  /// Returns the full Newton step from the present state without applying it; zero if the tangent is not positive
  /// definite.
  Vector step(const Load& load);

  /// Tells whether no cell outside the lumens is turned over.
  bool inOrder() const;

 private:
  bool factor(const Load& load, bool cautious);
  Vector solveWith(const Vector& right) const;
  double followForce(const Load& load, double wanted_kPa_mm, Vector& step) const;
  double allowedShare(const Vector& step) const;
  double missedBy(const Load& load) const;
  void advance(const Load& load, const Vector& step);

  const Body& body_;
  std::vector<int> unknown_;  ///< [2 * node + axis]: position in the order of elimination; -1 for fixed nodes
  int unknowns_ = 0;
  Eigen::SimplicialLDLT<Matrix, Eigen::Lower, Eigen::NaturalOrdering<int>> factor_;
  bool analysed_ = false;
};

}  // namespace insonate::reference
