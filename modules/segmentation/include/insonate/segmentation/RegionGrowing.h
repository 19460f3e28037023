#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/segmentation/Region.h>

#include <span>

namespace insonate {

/// All voxels of the box in the range that hang together with a seed by the faces of voxels in the range. Seeds are
/// points of the patient, mm. Refuses where no seed lies on such a voxel; fails when cancelled.
Result<Selection> connected(const CtVolume& ct, const VoxelBox& box, std::span<const Vec3> seeds_mm, HuRange range,
                            const Progress& progress = {});

struct Confidence {
  double deviations = 2.5;  ///< the range is the mean +- so many standard deviations; 0.5 to 10
  int rounds = 4;           ///< in which mean and deviation are measured again in what has grown; 0 to 20
  double seed_mm = 2;       ///< radius of the ball around each seed where they are measured first
};

/// Grows with a learned range: confidence-connected growing. `used` receives the last range, if not null.
Result<Selection> confidenceConnected(const CtVolume& ct, const VoxelBox& box, std::span<const Vec3> seeds_mm,
                                      const Confidence& confidence, const Progress& progress = {},
                                      HuRange* used = nullptr);

}  // namespace insonate
