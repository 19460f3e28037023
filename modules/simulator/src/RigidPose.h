#pragma once

#include <insonate/core/Transform.h>

#include <cmath>

namespace insonate {

/// True for a finite rotation and place, as far as numbers in single precision can tell.
inline bool isRigid(const Transform& t) {
  constexpr double kTolerance = 1e-4;
  if (!isFinite(t.offset)) return false;
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b <= a; ++b)
      if (!(std::abs(dot(t.linear.column[a], t.linear.column[b]) - (a == b)) < kTolerance)) return false;
  return determinant(t.linear) > 0;
}

}  // namespace insonate
