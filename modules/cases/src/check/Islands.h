#pragma once

#include <insonate/image/Volume.h>

#include <vector>

namespace insonate::check {

/// Voxels that hang together by faces.
struct Island {
  std::uint8_t label = 0;  ///< of its first voxel
  std::size_t voxels = 0;
  std::size_t first = 0;  ///< offset of its first voxel
};

/// Rule by which voxels are connected: only voxels of one label, or labeled voxels of any label.
enum class Joining { kOneLabel, kAnyLabel };

/// All islands of labeled voxels, in the order of their first voxels. Needs memory for rows of equal voxels only.
std::vector<Island> islandsOf(const LabelMap& labels, Joining joining);

}  // namespace insonate::check
