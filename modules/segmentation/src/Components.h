#pragma once

#include "Morphology.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace insonate::segmentation {

/// Voxels of a mask that hang together by their faces, kept as runs along i: a few hundred thousand runs stand for the
/// many millions of voxels of a scan.
class Components {
 public:
  struct Run {
    int begin, end;  ///< voxels [begin, end) along i
    int j, k;
    std::uint32_t component;
  };
  enum class Reach { Volume, Slice };

  Components(const Mask& mask, Reach reach, Work& work);

  /// Ordered by k, then j, then i.
  const std::vector<Run>& runs() const { return runs_; }
  /// Components are numbered 0 .. count() - 1.
  std::uint32_t count() const { return count_; }
  /// Number of voxels of each.
  std::vector<std::size_t> sizes() const;

  /// Component of a voxel that is set in the mask.
  std::uint32_t componentAt(int i, int j, int k) const;

  /// Sets the voxels of the chosen components to `value`.
  void paint(const std::vector<bool>& chosen, std::uint8_t value, Volume<std::uint8_t>& target) const;

 private:
  std::vector<Run> runs_;
  std::uint32_t count_ = 0;
};

}  // namespace insonate::segmentation
