#pragma once

#include <insonate/image/Volume.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace insonate {

/// Which labels make the structure, by number.
using LabelSet = std::array<bool, 256>;

/// Where the voxels of a structure lie: first and last index along each axis.
struct LabelBox {
  std::array<int, 3> first, last;
  std::size_t voxels = 0;
};

/// Empty when no voxel belongs to the structure.
std::optional<LabelBox> boxOf(const LabelMap& labels, const LabelSet& structure);

/// Voxels along each axis that make a block of at most this edge; at least 1.
std::array<int, 3> blockSize(const VolumeGeometry& geometry, double edge_mm);

/// How much of each block a structure fills, 0 to 255, over its box and an empty block around it. What would lie
/// outside the label map is empty, so a surface through the shares is closed.
Volume<std::uint8_t> structureShare(const LabelMap& labels, const LabelSet& structure, const LabelBox& box,
                                    const std::array<int, 3>& voxelsPerBlock);

}  // namespace insonate
