#pragma once

#include <insonate/image/Volume.h>

#include <vector>

namespace insonate::check {

/// One bit for each voxel.
using VoxelSet = std::vector<bool>;

/// Returns the voxels of `label` that are connected by faces, within the label, to a side of the volume. The sides are
/// the four faces of the volume that are parallel to `endAxis`.
VoxelSet floodFromSides(const LabelMap& labels, std::uint8_t label, int endAxis);

/// A connected component of a label: voxels joined by faces, edges or corners.
struct Part {
  std::size_t voxels = 0;
  int low = 0, high = 0;       ///< minimum and maximum index along the axis given to partsOf()
  Vec3 lowEnd_mm, highEnd_mm;  ///< mean patient positions of the component's voxels at index low and at index high
};

/// Returns all connected components of a label, largest first.
std::vector<Part> partsOf(const LabelMap& labels, std::uint8_t label, int axis);

/// Returns the longest side of the bounding box of the connected component that contains a voxel (continuous index); 0
/// outside the grid.
double pieceLength_mm(const LabelMap& labels, Vec3 index);

}  // namespace insonate::check
