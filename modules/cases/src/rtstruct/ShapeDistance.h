#pragma once

#include <cstdint>
#include <vector>

namespace insonate {

/// Binary image of one slice; rows lie one behind the other.
struct SliceMask {
  int columns = 0, rows = 0;
  std::vector<std::uint8_t> inside;  ///< 1 or 0 for each pixel
};

/// Returns for each pixel the distance (mm) to the nearest pixel on the other side of the border; negative outside.
/// Large values if the mask is all inside or all outside.
std::vector<float> shapeDistances(const SliceMask& mask, double betweenColumns_mm, double betweenRows_mm);

}  // namespace insonate
