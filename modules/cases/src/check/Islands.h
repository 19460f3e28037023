#pragma once

#include <insonate/image/Volume.h>

#include <vector>

namespace insonate::check {

/// A connected component of labeled voxels, joined by faces.
struct Island {
  std::uint8_t label = 0;  ///< label of the component's first voxel
  std::size_t voxels = 0;
  std::size_t first = 0;  ///< offset of the component's first voxel in the label map
};

/// Rule by which voxels are connected: only voxels of one label, or labeled voxels of any label.
enum class Joining { kOneLabel, kAnyLabel };

/// Returns all islands of labeled voxels, in the order of their first voxels. Memory grows with the number of runs of
/// equal voxels, not with the number of voxels.
std::vector<Island> islandsOf(const LabelMap& labels, Joining joining);

}  // namespace insonate::check
