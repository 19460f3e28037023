#pragma once

#include "Morphology.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace insonate::segmentation {

/// Connected components of a mask, joined by faces of voxels and stored as runs along i: a scan's many millions of
/// voxels make only a few hundred thousand runs.
class Components {
 public:
  struct Run {
    int begin, end;  ///< voxels [begin, end) along i
    int j, k;
    std::uint32_t component;
  };
  enum class Reach { Volume, Slice };

  Components(const Mask& mask, Reach reach, Work& work);

  /// Returns all runs of set voxels, ordered by k, then j, then i.
  const std::vector<Run>& runs() const { return runs_; }
  /// Returns the number of components. Their numbers are 0 .. count() - 1.
  std::uint32_t count() const { return count_; }
  /// Returns the number of voxels of each component.
  std::vector<std::size_t> sizes() const;

  /// Returns the component of a voxel that is set in the mask.
  std::uint32_t componentAt(int i, int j, int k) const;

  /// Sets the voxels of the chosen components in `target` to `value`.
  void paint(const std::vector<bool>& chosen, std::uint8_t value, Volume<std::uint8_t>& target) const;

 private:
  std::vector<Run> runs_;
  std::uint32_t count_ = 0;
};

}  // namespace insonate::segmentation
