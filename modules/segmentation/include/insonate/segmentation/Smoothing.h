#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/segmentation/LabelEdit.h>

namespace insonate {

// Smoothing of a selection within its box, which must leave a margin of the radius around the shape. Voxels beyond the
// box are unknown: they neither grow into the box nor erode the shape. All functions refuse to make a non-empty shape
// vanish, and fail when cancelled.

/// Sets each voxel to the majority of the block of (2 radius)^3 around it: removes bumps, fills dents, keeps edges.
Result<Selection> medianSmoothed(const Selection& shape, double radius_mm, const Progress& progress = {});

/// Removes parts into which a ball of the radius does not fit: thin bridges, spikes.
Result<Selection> opened(const Selection& shape, double radius_mm, const Progress& progress = {});

/// Fills gaps and pits into which a ball of the radius does not fit.
Result<Selection> closed(const Selection& shape, double radius_mm, const Progress& progress = {});

/// Blurs with a Gaussian and thresholds at one half: rounds all details of the size of `sigma_mm`.
Result<Selection> gaussianSmoothed(const Selection& shape, double sigma_mm, const Progress& progress = {});

/// Smooths several labels together. Each of their voxels in the box gets the label whose blurred share is largest
/// there, so that neighboring structures stay in contact, without gaps or overlaps. Voxels of other labels are not
/// changed.
Result<Proposal> jointlySmoothed(const LabelMap& labels, const VoxelBox& box, const LabelSet& which, double sigma_mm,
                                 const Progress& progress = {});

}  // namespace insonate
