#pragma once

#include "elastic/GridMatrix.h"
#include "elastic/GridOrder.h"

#include <vector>

namespace insonate::elastic {

struct FrontWork {
  const GridOrder& order;
  const GridMatrix& matrix;
  float* panels;
  float* right;  ///< right-hand side, in the order of elimination; forward substitution is done during elimination
  /// Buffers for the updates that fronts pass to their parents, [side][depth].
  std::vector<std::vector<float>>* updates;
};

/// Assembles and eliminates one front, whose child fronts must have been eliminated. Stores the factor's rows as an
/// upper triangle. Returns the number of pivots that were not positive.
int eliminateFront(const FrontWork& work, int front);

/// Solves with the transposed factor. `x` is in the order of elimination; `border` is a buffer.
void substituteForward(const GridOrder& order, const float* panels, float* x, float* border);
/// Solves with the factor. `x` is in the order of elimination; `border` is a buffer.
void substituteBackward(const GridOrder& order, const float* panels, float* x, float* border);

}  // namespace insonate::elastic
