#pragma once

#include <insonate/bench/SegmentationBench.h>
#include <insonate/segmentation/Region.h>

namespace insonate::bench {

/// Computes the Dice scores that a perfect segmentation of a vessel's lumen would reach against `mask`, alone and with
/// each wall thickness of kWalls_mm. The perfect lumen consists of the voxels (with fractions) brighter than the mean
/// of muscle and the blood in the mask. Only voxels of `where` count, whose box contains the mask. Fails if cancelled.
Result<WallScores> scoreExactLumen(const CtVolume& ct, const Selection& mask, const Selection& where,
                                   const Progress& progress);

}  // namespace insonate::bench
