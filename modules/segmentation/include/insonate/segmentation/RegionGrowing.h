#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/segmentation/Region.h>

#include <span>

namespace insonate {

/// Returns all voxels of the box within the range that are connected to a seed by faces of voxels within the range.
/// Seeds are points of the patient, mm. Refuses seeds if none lies on a voxel within the range; fails when cancelled.
Result<Selection> connected(const CtVolume& ct, const VoxelBox& box, std::span<const Vec3> seeds_mm, HuRange range,
                            const Progress& progress = {});

struct Confidence {
  double deviations = 2.5;  ///< the range is the mean plus or minus this many standard deviations; 0.5 to 10
  int rounds = 4;           ///< number of times that mean and SD are measured again in the grown region; 0 to 20
  double seed_mm = 2;       ///< radius of the ball around each seed for the first measurement
};

/// Confidence-connected growing: grows with a range that is measured in the region itself. `used` receives the last
/// range, if not null.
Result<Selection> confidenceConnected(const CtVolume& ct, const VoxelBox& box, std::span<const Vec3> seeds_mm,
                                      const Confidence& confidence, const Progress& progress = {},
                                      HuRange* used = nullptr);

}  // namespace insonate
