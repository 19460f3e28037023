#pragma once

#include <insonate/image/Volume.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace insonate {

/// Set of labels that form a structure, by number.
using LabelSet = std::array<bool, 256>;

/// Extent of a structure's voxels: first and last index along each axis.
struct LabelBox {
  std::array<int, 3> first, last;
  std::size_t voxels = 0;
};

/// Box of the structure's voxels; empty if there are none.
std::optional<LabelBox> boxOf(const LabelMap& labels, const LabelSet& structure);

/// Voxels along each axis that make a block of at most this edge; at least 1.
std::array<int, 3> blockSize(const VolumeGeometry& geometry, double edge_mm);

/// Share of each block that a structure fills, 0 to 255, over its box and an empty block around it. Blocks outside the
/// label map are empty, so that a surface through the shares is closed.
Volume<std::uint8_t> structureShare(const LabelMap& labels, const LabelSet& structure, const LabelBox& box,
                                    const std::array<int, 3>& voxelsPerBlock);

}  // namespace insonate
