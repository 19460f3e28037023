#pragma once

#include <insonate/bench/SegmentationBench.h>
#include <insonate/segmentation/Region.h>

namespace insonate::bench {

/// Dice against `mask` of a lumen that is found exactly, alone and with each wall: voxels brighter than half-way from
/// the mask's blood to muscle, in fractions of voxels. Only voxels of `where`, whose box holds the mask, count. Fails
/// when cancelled.
Result<WallScores> scoreExactLumen(const CtVolume& ct, const Selection& mask, const Selection& where,
                                   const Progress& progress);

}  // namespace insonate::bench
