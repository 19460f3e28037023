#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/segmentation/Region.h>

#include <span>

namespace insonate {

/// A front that runs from the seeds at 1 mm a unit of time in even tissue and slower the steeper the CT rises:
///   speed = 1 / (1 + (gradient / edge)^2)
/// J. A. Sethian, "A fast marching level set method for monotonically advancing fronts", PNAS 93, 1996.
struct MarchingFront {
  double reach_mm = 15;       ///< the time at which it stops; above 0
  double edge_HUpmm = 30;     ///< where it runs at half its speed; above 0
  double smoothing_mm = 0.8;  ///< standard deviation of the blur before the gradient; 0 or more
};

/// Returns the voxels that the front reached in the box. Seeds are points in patient space, mm. Refuses if no seed
/// lies in the box; fails when cancelled.
Result<Selection> marched(const CtVolume& ct, const VoxelBox& box, std::span<const Vec3> seeds_mm,
                          const MarchingFront& front, const Progress& progress = {});

}  // namespace insonate
