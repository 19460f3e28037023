#pragma once

#include "Work.h"

#include <insonate/image/Volume.h>

namespace insonate::segmentation {

/// 1 inside, 0 outside.
using Mask = Volume<std::uint8_t>;

/// Morphology with a ball of `radius_mm` between voxel centres. What lies beyond the grid is unknown: it neither grows
/// into the grid nor erodes it.
void dilate(Mask& mask, double radius_mm, Work& work);
void erode(Mask& mask, double radius_mm, Work& work);
void open(Mask& mask, double radius_mm, Work& work);
void close(Mask& mask, double radius_mm, Work& work);

/// Adds the six neighbors of each voxel.
void dilateToNeighbours(Mask& mask, Work& work);

/// Each voxel becomes what most of its 3 x 3 neighbors in the slice are.
void majorityInSlice(Mask& mask, Work& work);

}  // namespace insonate::segmentation
