#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/segmentation/LabelEdit.h>

namespace insonate {

// These functions smooth a selection within its box, which must leave a margin of the radius around the shape. Voxels
// beyond the box are unknown: they neither grow into the box nor erode the shape. All functions fail if the result of a
// non-empty shape would be empty, and when cancelled.

/// Sets each voxel to the value of the majority of voxels in the cube of edge length 2 radius_mm around it. This
/// removes bumps, fills dents and keeps edges.
Result<Selection> medianSmoothed(const Selection& shape, double radius_mm, const Progress& progress = {});

/// Removes parts of the shape, such as thin bridges and spikes, into which a ball of this radius does not fit.
Result<Selection> opened(const Selection& shape, double radius_mm, const Progress& progress = {});

/// Fills gaps and pits into which a ball of the radius does not fit.
Result<Selection> closed(const Selection& shape, double radius_mm, const Progress& progress = {});

/// Blurs the shape with a Gaussian of standard deviation `sigma_mm` and applies a threshold of one half. This rounds
/// details of about that size.
Result<Selection> gaussianSmoothed(const Selection& shape, double sigma_mm, const Progress& progress = {});

/// Smooths several labels together. Each voxel of one of these labels gets the label with the largest value after
/// blurring, so that neighboring structures stay in contact without gaps or overlaps. Voxels of other labels are not
/// changed.
Result<Proposal> jointlySmoothed(const LabelMap& labels, const VoxelBox& box, const LabelSet& which, double sigma_mm,
                                 const Progress& progress = {});

}  // namespace insonate
