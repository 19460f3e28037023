#pragma once

#include <insonate/image/Volume.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace insonate {

/// Set of the labels that form one structure: element n is true if label n belongs to the structure.
using LabelSet = std::array<bool, 256>;

/// Bounding box of a structure's voxels: first and last index along each axis.
struct LabelBox {
  std::array<int, 3> first, last;
  std::size_t voxels = 0;
};

/// Returns the bounding box of the structure's voxels; no value if there are none.
std::optional<LabelBox> boxOf(const LabelMap& labels, const LabelSet& structure);

/// Returns the number of voxels along each axis that form a block with edges of at most `edge_mm`; at least 1.
std::array<int, 3> blockSize(const VolumeGeometry& geometry, double edge_mm);

/// Returns the share of each block that the structure fills, 0 to 255 for none to all, for the blocks of `box` and one
/// more block on each side. Blocks outside the label map are empty, so that a surface through the result is closed.
Volume<std::uint8_t> structureShare(const LabelMap& labels, const LabelSet& structure, const LabelBox& box,
                                    const std::array<int, 3>& voxelsPerBlock);

}  // namespace insonate
