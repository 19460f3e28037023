#pragma once

#include <insonate/image/VoxelBox.h>

#include <cstdint>
#include <span>
#include <string>

namespace insonate {

/// A set of voxels in a box of a grid, e.g. the voxels that a tool has selected.
struct Selection {
  VoxelBox box;
  Volume<std::uint8_t> mask;  ///< 1 for selected voxels, else 0, on the grid of `box`; no voxels if the box is empty

  Selection() = default;
  /// Makes an empty selection in a box, which must lie within the grid.
  Selection(const VolumeGeometry& geometry, const VoxelBox& where);

  /// Tells whether a voxel is selected; indices are those of the whole grid.
  bool isSelected(int i, int j, int k) const {
    return box.contains(i, j, k) && mask.at(i - box.first[0], j - box.first[1], k - box.first[2]);
  }
  std::size_t count() const;
};

/// Returns the voxels of a label in a box.
Selection voxelsOf(const LabelMap& labels, std::uint8_t label, const VoxelBox& where);
/// Returns the bounding box of all voxels of a label; empty if there are none.
VoxelBox boundingBoxOf(const LabelMap& labels, std::uint8_t label);

/// Range of Hounsfield units, both ends included.
struct HuRange {
  int low = -32768, high = 32767;
  bool operator==(const HuRange&) const = default;
  bool contains(int hu) const { return hu >= low && hu <= high; }
};

/// Labels that a tool proposes to write: one label, or kKeep, for each voxel of a box.
struct Proposal {
  static constexpr std::uint8_t kKeep = 255;  ///< entry for a voxel that keeps its label
  VoxelBox box;
  Volume<std::uint8_t> labels;
};

/// Returns a proposal that gives the selected voxels the label and keeps all others.
Proposal proposePainting(Selection chosen, std::uint8_t label);
/// Returns a proposal that changes the shape of a label within the selection's box to `shape`: selected voxels get the
/// label, and voxels of the label that are not selected get the label `rest`.
Proposal proposeShape(Selection shape, const LabelMap& labels, std::uint8_t label, std::uint8_t rest);

}  // namespace insonate
