#pragma once

#include "elastic/GridMatrix.h"
#include "elastic/GridOrder.h"

#include <vector>

namespace insonate::elastic {

/// Cholesky factor of a GridMatrix by the multifrontal method (I. S. Duff and J. K. Reid, ACM TOMS 9, 1983), in single
/// precision. Allocates only if the grid is larger than every earlier one.
class GridFactor {
 public:
  void prepare(int columns, int rows);

  /// Factors the matrix and solves the linear system: `x` ([2 * node + axis]) holds the right-hand side, and receives
  /// the solution. Returns false, without a solution, if the matrix is not positive definite.
  bool factor(const GridMatrix& matrix, std::vector<float>& x);

  /// Solves the system for another right-hand side `x` with the same factor; `x` receives the solution.
  void solve(std::vector<float>& x);

  std::size_t factorBytes() const { return panels_.size() * sizeof(float); }

 private:
  void order(const std::vector<float>& x);
  void restore(std::vector<float>& x) const;

  GridOrder order_;
  std::vector<float> panels_;
  std::vector<std::vector<float>> updates_[2];  ///< updates that fronts pass to their parents, [side][depth]
  std::vector<float> ordered_, border_;
};

}  // namespace insonate::elastic
