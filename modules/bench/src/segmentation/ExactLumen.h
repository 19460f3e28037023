#pragma once

#include <insonate/bench/SegmentationBench.h>
#include <insonate/segmentation/Region.h>

namespace insonate::bench {

/// Dice score that a perfect segmentation would reach against `mask`. The perfect lumen contains the voxels, as
/// fractions, that are brighter than the mean of muscle and the mask's blood. It is scored alone and with each
/// thickness of wall. Only voxels of `where` count, whose box contains the mask. Fails if cancelled.
Result<WallScores> scoreExactLumen(const CtVolume& ct, const Selection& mask, const Selection& where,
                                   const Progress& progress);

}  // namespace insonate::bench
