#pragma once

#include <insonate/image/Volume.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace insonate {

/// Labels that form a structure: true at the number of each.
using LabelSet = std::array<bool, 256>;

/// Bounding box of a structure's voxels: first and last index along each axis.
struct LabelBox {
  std::array<int, 3> first, last;
  std::size_t voxels = 0;
};

/// Returns the bounding box of the structure's voxels; no value if there are none.
std::optional<LabelBox> boxOf(const LabelMap& labels, const LabelSet& structure);

/// Returns how many voxels along each axis make a block of at most this edge; at least 1.
std::array<int, 3> blockSize(const VolumeGeometry& geometry, double edge_mm);

/// Returns how much of each block the structure fills, 0 to 255 for none to all, over its box and one block around it.
/// Blocks outside the label map are empty, so that a surface through the result is closed.
Volume<std::uint8_t> structureShare(const LabelMap& labels, const LabelSet& structure, const LabelBox& box,
                                    const std::array<int, 3>& voxelsPerBlock);

}  // namespace insonate
