#pragma once

#include <insonate/core/Vec3.h>

namespace insonate {

/// A box in patient LPS, millimeters.
struct Region {
  Vec3 low_mm, high_mm;
};

}  // namespace insonate
