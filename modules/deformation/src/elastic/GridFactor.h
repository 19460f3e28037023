#pragma once

#include "elastic/GridMatrix.h"
#include "elastic/GridOrder.h"

#include <vector>

namespace insonate::elastic {

/// Cholesky factor of a GridMatrix by fronts (multifrontal method; I. S. Duff and J. K. Reid, ACM TOMS 9, 1983), in
/// single precision. Allocates only when the grid's size changes.
class GridFactor {
 public:
  void prepare(int columns, int rows);

  /// False where the matrix was not positive definite; pivots that were not are taken out, so that the unknowns behind
  /// them stay as they are.
  bool factor(const GridMatrix& matrix);

  /// [2 * node + axis], in place.
  void solve(std::vector<float>& x);

  std::size_t factorBytes() const { return panels_.size() * sizeof(float); }

 private:
  GridOrder order_;
  std::vector<float> panels_;
  std::vector<std::vector<float>> updates_[2];  ///< [side][depth]
  std::vector<float> ordered_, border_;
};

}  // namespace insonate::elastic
