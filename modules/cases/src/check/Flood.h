#pragma once

#include <insonate/image/Volume.h>

#include <vector>

namespace insonate::check {

/// One bit for each voxel.
using VoxelSet = std::vector<bool>;

/// The voxels of `label` that a path of face neighbors of that label joins to a side of the volume, where the
/// sides are the four faces that `endAxis` does not cross.
VoxelSet floodFromSides(const LabelMap& labels, std::uint8_t label, int endAxis);

/// Voxels of a label that hang together by faces, edges or corners.
struct Part {
  std::size_t voxels = 0;
  int low = 0, high = 0;       ///< first and last index along the axis that was asked for
  Vec3 lowEnd_mm, highEnd_mm;  ///< patient centers of the voxels at these two indices
};

/// All parts of a label, largest first.
std::vector<Part> partsOf(const LabelMap& labels, std::uint8_t label, int axis);

/// Longest side of the box around what hangs together with a voxel (continuous index) of its label; 0 outside the grid.
double pieceLength_mm(const LabelMap& labels, Vec3 index);

}  // namespace insonate::check
