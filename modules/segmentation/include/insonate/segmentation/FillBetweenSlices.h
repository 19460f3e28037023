#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/segmentation/Region.h>

namespace insonate {

/// Draws a shape in the slices across an axis of the grid (0, 1, 2) that lie between slices in which it was drawn, by
/// blending their distance maps: S. P. Raya, J. K. Udupa, "Shape-based interpolation of multidimensional objects", IEEE
/// Trans. Med. Imaging 9, 1990. The outlines are shifted along the line between their centroids, so that a vessel that
/// runs obliquely stays one. Slices that were drawn keep what they have. Refuses fewer than two drawn slices, or none
/// between them; fails when cancelled.
Result<Selection> filledBetween(const Selection& slices, int axis, const Progress& progress = {});

}  // namespace insonate
