#pragma once

#include "elastic/GridMatrix.h"
#include "elastic/GridOrder.h"

#include <vector>

namespace insonate::elastic {

struct FrontWork {
  const GridOrder& order;
  const GridMatrix& matrix;
  float* panels;
  float* right;  ///< right-hand side, in the order of elimination: substituted forward on the way
  std::vector<std::vector<float>>* updates;  ///< two: [side][depth]
};

/// Assembles and eliminates one front whose children are done. The factor's rows are those of the upper triangle.
/// Returns how many pivots were not positive.
int eliminateFront(const FrontWork& work, int front);

/// Solves with the transposed factor; `x` is in the order of elimination, `border` a buffer.
void substituteForward(const GridOrder& order, const float* panels, float* x, float* border);
/// Solves with the factor.
void substituteBackward(const GridOrder& order, const float* panels, float* x, float* border);

}  // namespace insonate::elastic
