#pragma once

#include "StructureFile.h"

#include <insonate/image/Volume.h>
#include <insonate/image/VoxelBox.h>

#include <optional>
#include <vector>

namespace insonate {

/// Spacing of the planes in which the structures of a file were drawn.
struct ContourSpacing {
  double reach_mm = 0;  ///< distance from a plane up to which its contours hold beyond the last plane
  double step_mm = 0;   ///< usual distance of neighboring planes
};

/// A structure as voxels of a block of a grid.
struct FilledStructure {
  VoxelBox box;                      ///< block of the grid; empty if the structure lies outside
  std::vector<std::uint8_t> inside;  ///< 1 or 0 for each voxel of the block, as in a volume
  int interpolatedSlices = 0;        ///< slices without contours between contoured slices
  std::size_t contoursOutside = 0;   ///< contours of planes beyond the first or last slice
};

/// Tells whether all contours lie in planes parallel to the slices of the grid.
bool areParallelToSlices(const std::vector<ContourCorners>& contours, const VolumeGeometry& grid);

/// Returns a grid whose slices lie in the planes of the contours, fine enough for resampling to `grid`; no value if the
/// contours do not lie in parallel planes, or if the grid would be too large.
std::optional<VolumeGeometry> gridOfPlanes(const std::vector<ContourCorners>& contours, const VolumeGeometry& grid);

/// Determines the spacing of all planes that are parallel to the slices of `grid`.
ContourSpacing spacingOfPlanes(const std::vector<DrawnStructure>& structures, const VolumeGeometry& grid);

/// Fills contours that are parallel to the slices of `grid`: a voxel is inside if its center lies in an odd number of
/// the contours of its plane.
FilledStructure fillContours(const std::vector<ContourCorners>& contours, const VolumeGeometry& grid,
                             const ContourSpacing& spacing);

}  // namespace insonate
