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

  /// Factors the matrix and solves for `x` ([2 * node + axis], in place). Returns false, without a solution, if the
  /// matrix is not positive definite.
  bool factor(const GridMatrix& matrix, std::vector<float>& x);

  /// Solves for another right-hand side with the same factor.
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
