#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/segmentation/Region.h>

#include <span>

namespace insonate {

/// Returns the voxels of the box whose CT values lie in the range and that are connected with a seed, through faces of
/// such voxels. Seeds are points in patient space. Fails if no seed lies on a voxel in the range, and when cancelled.
Result<Selection> connected(const CtVolume& ct, const VoxelBox& box, std::span<const Vec3> seeds_mm, HuRange range,
                            const Progress& progress = {});

struct Confidence {
  double deviations = 2.5;  ///< half width of the range about the mean, in standard deviations; 0.5 to 10
  /// number of times that mean and standard deviation are measured again in the grown region; 0 to 20
  int rounds = 4;
  double seed_mm = 2;  ///< radius of the ball around each seed for the first measurement
};

/// Grows a region as connected() does, with a range of CT values that is measured in the region itself
/// (confidence-connected region growing): mean plus and minus a number of standard deviations. `used`, if not null,
/// receives the range of the last round.
Result<Selection> confidenceConnected(const CtVolume& ct, const VoxelBox& box, std::span<const Vec3> seeds_mm,
                                      const Confidence& confidence, const Progress& progress = {},
                                      HuRange* used = nullptr);

}  // namespace insonate
