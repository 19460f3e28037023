#pragma once

#include <insonate/image/VoxelBox.h>

#include <cstdint>
#include <span>
#include <string>

namespace insonate {

/// Voxels that a tool has chosen in a block of a grid, 1 or 0 each. What a window shows as a preview.
struct Selection {
  VoxelBox box;
  Volume<std::uint8_t> mask;  ///< its grid is that of the box; no voxels where the box is empty

  Selection() = default;
  /// Makes an empty selection. The box lies in the grid.
  Selection(const VolumeGeometry& geometry, const VoxelBox& where);

  /// Tells whether a voxel is selected, by indices of the whole grid.
  bool chosen(int i, int j, int k) const {
    return box.contains(i, j, k) && mask.at(i - box.first[0], j - box.first[1], k - box.first[2]);
  }
  std::size_t count() const;
};

/// The voxels of a label in a block.
Selection voxelsOf(const LabelMap& labels, std::uint8_t label, const VoxelBox& where);
/// The block that holds all voxels of a label; empty where it has none.
VoxelBox extentOf(const LabelMap& labels, std::uint8_t label);

/// Hounsfield units, both ends included.
struct HuRange {
  int low = -32768, high = 32767;
  bool operator==(const HuRange&) const = default;
  bool contains(int hu) const { return hu >= low && hu <= high; }
};

/// Labels that a tool would write: one for each voxel of a block, or kKeep.
struct Proposal {
  static constexpr std::uint8_t kKeep = 255;  ///< the voxel stays as it is
  VoxelBox box;
  Volume<std::uint8_t> labels;
};

/// Chosen voxels get the label, all others stay.
Proposal painted(Selection chosen, std::uint8_t label);
/// Proposal that gives the label this shape in the selection's block: it takes the selected voxels, and those it loses
/// become `rest`.
Proposal reshaped(Selection shape, const LabelMap& labels, std::uint8_t label, std::uint8_t rest);

}  // namespace insonate
