#pragma once

#include <insonate/core/Transform.h>

#include <cmath>

namespace insonate {

/// Tells whether a transform is rigid: a finite rotation and translation, within single precision.
inline bool isRigid(const Transform& t) {
  constexpr double kTolerance = 1e-4;
  if (!isFinite(t.offset)) return false;
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b <= a; ++b)
      if (!(std::abs(dot(t.linear.column[a], t.linear.column[b]) - (a == b)) < kTolerance)) return false;
  return determinant(t.linear) > 0;
}

}  // namespace insonate
