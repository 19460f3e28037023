#pragma once

#include <insonate/bench/SegmentationBench.h>
#include <insonate/segmentation/Region.h>

namespace insonate::bench {

/// Dice that a perfect segmentation would reach against `mask`. The perfect lumen holds the voxels, in fractions, that
/// are brighter than half-way from muscle to the mask's blood; it is scored alone and with each thickness of wall. Only
/// voxels of `where`, whose box holds the mask, count. Fails when cancelled.
Result<WallScores> scoreExactLumen(const CtVolume& ct, const Selection& mask, const Selection& where,
                                   const Progress& progress);

}  // namespace insonate::bench
