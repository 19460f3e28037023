#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/segmentation/Region.h>

#include <span>

namespace insonate {

/// Parameters of a front that spreads from the seeds (fast marching). The front moves by 1 mm per unit of time in
/// homogeneous tissue, and more slowly where the CT's gradient is steep:
///   speed = 1 / (1 + (gradient / edge)^2)
/// J. A. Sethian, "A fast marching level set method for monotonically advancing fronts", PNAS 93, 1996.
struct MarchingFront {
  double reach_mm = 15;       ///< distance, in homogeneous tissue, at which the front stops; above 0
  double edge_HUpmm = 30;     ///< CT gradient at which the front moves at half speed; above 0
  double smoothing_mm = 0.8;  ///< standard deviation of the CT's blur before the gradient is computed; 0 or more
};

/// Returns the voxels of the box that the front has reached when it stops. Seeds are points in patient space, mm.
/// Refuses seeds that all lie outside the box; fails when cancelled.
Result<Selection> fastMarching(const CtVolume& ct, const VoxelBox& box, std::span<const Vec3> seeds_mm,
                               const MarchingFront& front, const Progress& progress = {});

}  // namespace insonate
