#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/segmentation/Region.h>

namespace insonate {

/// Interpolates a shape that was drawn in some slices perpendicular to an axis of the grid (0, 1, 2). The slices in
/// between are filled by interpolation of the drawn slices' distance maps (S. P. Raya, J. K. Udupa, "Shape-based
/// interpolation of multidimensional objects", IEEE Trans. Med. Imaging 9, 1990). The outlines are shifted along the
/// line between their centroids, so that a vessel that runs obliquely stays connected. Drawn slices are not changed.
/// Refuses fewer than two drawn slices, and drawn slices without a slice between them; fails when cancelled.
Result<Selection> fillBetweenSlices(const Selection& slices, int axis, const Progress& progress = {});

}  // namespace insonate
