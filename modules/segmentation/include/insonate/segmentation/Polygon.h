#pragma once

#include <insonate/core/Result.h>
#include <insonate/segmentation/Region.h>

#include <optional>
#include <span>

namespace insonate {

/// Returns the voxels of a slice perpendicular to an axis of the grid (0, 1, 2) whose centers lie in a drawn polygon.
/// Corners are points in patient space, mm; the first one determines the slice. The even-odd rule applies if the
/// outline crosses itself. Refuses fewer than three corners and a first corner outside the grid.
Result<Selection> drawn(const VolumeGeometry& geometry, int sliceAxis, std::span<const Vec3> corners_mm);

/// View by which a polygon on the screen is extended into depth.
struct ScissorsView {
  Vec3 along{0, 0, 1};           ///< direction of view, unit vector in patient space
  std::optional<Vec3> eye_mm{};  ///< eye point of a perspective view; empty for parallel projection
  bool outside = false;          ///< true: select the voxels outside the polygon
  double depth_mm = 0;  ///< maximum depth along the view; in parallel projection, to both sides; 0 for no limit
  std::optional<Vec3> surface_mm{};  ///< point where the depth begins, patient; if empty, the first corner
};

/// Returns the voxels of a box that appear within a polygon in the view, down to the view's depth. Corners are points
/// of the patient, mm, anywhere on the line of sight through the corner; even-odd rule. Refuses fewer than three
/// corners, and corners behind the eye.
Result<Selection> scissored(const VolumeGeometry& geometry, const VoxelBox& box, std::span<const Vec3> corners_mm,
                            const ScissorsView& view);

}  // namespace insonate
