#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/segmentation/LabelEdit.h>

namespace insonate {

// Smoother shapes of a selection, in its box: give the box a margin of the radius around the shape. What lies beyond
// the box is unknown and neither grows into it nor erodes it. All refuse to let a shape vanish that was there, and fail
// when cancelled.

/// Each voxel becomes what most of a block of (2 radius)^3 around it is: takes bumps and fills dents, keeps edges.
Result<Selection> medianSmoothed(const Selection& shape, double radius_mm, const Progress& progress = {});

/// Removes what a ball of the radius does not fit into: thin bridges, spikes.
Result<Selection> opened(const Selection& shape, double radius_mm, const Progress& progress = {});

/// Fills what a ball of the radius does not fit into: gaps, pits.
Result<Selection> closed(const Selection& shape, double radius_mm, const Progress& progress = {});

/// Blurred with a Gaussian and cut at half: rounds everything of the size of `sigma_mm`.
Result<Selection> gaussianSmoothed(const Selection& shape, double sigma_mm, const Progress& progress = {});

/// All these labels at once: each of their voxels in the box goes to the one whose blurred share is largest there, so
/// that neighbors stay neighbors, without gaps or overlaps. Other labels' voxels stay.
Result<Proposal> jointlySmoothed(const LabelMap& labels, const VoxelBox& box, const LabelSet& which, double sigma_mm,
                                 const Progress& progress = {});

}  // namespace insonate
