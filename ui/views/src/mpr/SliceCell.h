#pragma once

#include <algorithm>

namespace insonate::views {

/// The voxels on both sides of a continuous index in [-0.5, size - 0.5), clamped to voxel centers.
struct SliceCell {
  int low, high;
  float share;  ///< weight of the higher voxel
  SliceCell(double index, int size) {
    const double inside = std::clamp(index, 0.0, size - 1.0);
    low = static_cast<int>(inside);
    high = std::min(low + 1, size - 1);
    share = static_cast<float>(inside - low);
  }
};

inline float between(float a, float b, float share) {
  return a + (b - a) * share;
}

}  // namespace insonate::views
