#pragma once

#include <insonate/segmentation/Region.h>

#include <optional>
#include <span>

namespace insonate {

struct Brush {
  double radius_mm = 4;            ///< radius of the circle or sphere; above 0
  std::optional<int> sliceAxis{};  ///< circle in the slice perpendicular to this grid axis (0, 1, 2); empty: sphere
};

/// Returns the voxels whose centers lie within the brush's radius of a stroke. The stroke is a line through one or more
/// points in patient space. A circle paints only in the slice that contains the first point. The voxel nearest to each
/// point is always included, so that the smallest brush paints at least one voxel. A stroke outside the grid selects
/// nothing. Takes a few milliseconds; the time depends on the stroke's size, not on the CT's.
Selection strokeVoxels(const VolumeGeometry& geometry, std::span<const Vec3> stroke_mm, const Brush& brush);

}  // namespace insonate
