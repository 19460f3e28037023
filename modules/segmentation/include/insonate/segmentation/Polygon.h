#pragma once

#include <insonate/core/Result.h>
#include <insonate/segmentation/Region.h>

#include <optional>
#include <span>

namespace insonate {

/// Returns the voxels of one slice whose centers lie inside a polygon that the author has drawn on the slice. The slice
/// is perpendicular to the axis `sliceAxis` of the grid (0, 1, 2) and contains the first corner. Corners are points in
/// patient space, mm. If the outline crosses itself, the even-odd rule applies. Refuses fewer than three corners and a
/// first corner outside the grid.
Result<Selection> polygonVoxels(const VolumeGeometry& geometry, int sliceAxis, std::span<const Vec3> corners_mm);

/// Projection by which a polygon on the screen becomes a volume: the polygon is extended along the direction of view.
struct ScissorsView {
  Vec3 along{0, 0, 1};           ///< direction of view, unit vector in patient space
  std::optional<Vec3> eye_mm{};  ///< eye point of a perspective view; empty for parallel projection
  bool outside = false;          ///< true: select the voxels outside the polygon
  /// maximum depth along the direction of view, in parallel projection to both sides of `surface_mm`; 0: no limit
  double depth_mm = 0;
  std::optional<Vec3> surface_mm{};  ///< point at which the depth begins, patient space; empty: the first corner
};

/// Returns the voxels of a box that appear inside a polygon in the view, down to the depth of the view. Each corner is
/// any point, in patient space, on the line of sight through that corner of the polygon. If the outline crosses itself,
/// the even-odd rule applies. Refuses fewer than three corners, and corners behind the eye.
Result<Selection> scissorsVoxels(const VolumeGeometry& geometry, const VoxelBox& box, std::span<const Vec3> corners_mm,
                                 const ScissorsView& view);

}  // namespace insonate
