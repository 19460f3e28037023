#pragma once

#include "elastic/GridMatrix.h"
#include "elastic/GridOrder.h"

#include <vector>

namespace insonate::elastic {

/// Cholesky factor of a GridMatrix by fronts (multifrontal method; I. S. Duff and J. K. Reid, ACM TOMS 9, 1983), in
/// single precision. Allocates only for a grid larger than those before.
class GridFactor {
 public:
  void prepare(int columns, int rows);

  /// Factors the matrix and solves for `x` ([2 * node + axis], in place). False if the matrix is not positive
  /// definite: there is no solution then.
  bool factor(const GridMatrix& matrix, std::vector<float>& x);

  /// Solves for another right-hand side.
  void solve(std::vector<float>& x);

  std::size_t factorBytes() const { return panels_.size() * sizeof(float); }

 private:
  void order(const std::vector<float>& x);
  void restore(std::vector<float>& x) const;

  GridOrder order_;
  std::vector<float> panels_;
  std::vector<std::vector<float>> updates_[2];  ///< [side][depth]
  std::vector<float> ordered_, border_;
};

}  // namespace insonate::elastic
