#pragma once

#include <insonate/core/Result.h>
#include <insonate/segmentation/Region.h>

#include <optional>
#include <span>

namespace insonate {

/// Returns the voxels of a slice across an axis of the grid (0, 1, 2) whose centers lie in a drawn polygon. Corners
/// are points in patient space, mm; the slice is that of the first. The even-odd rule applies where the outline
/// crosses itself. Refuses fewer than three corners and a first corner beside the grid.
Result<Selection> drawn(const VolumeGeometry& geometry, int sliceAxis, std::span<const Vec3> corners_mm);

/// Projection that extends a polygon on the screen into depth.
struct ScissorsView {
  Vec3 along{0, 0, 1};               ///< the way one looks, patient, unit
  std::optional<Vec3> eye_mm{};      ///< of a perspective view; without, all looks are parallel
  bool outside = false;              ///< choose what lies outside the polygon
  double depth_mm = 0;               ///< how deep, of parallel looks to either side; 0 for through everything
  std::optional<Vec3> surface_mm{};  ///< where the depth begins, patient; without, at the first corner
};

/// The voxels of a box that one sees in a polygon, as deep as the view says. Corners are points of the patient, mm,
/// anywhere in the look through the corner; even-odd rule. Refuses fewer than three corners, and corners behind the
/// eye.
Result<Selection> scissored(const VolumeGeometry& geometry, const VoxelBox& box, std::span<const Vec3> corners_mm,
                            const ScissorsView& view);

}  // namespace insonate
