#pragma once

#include "Work.h"

#include <insonate/image/Volume.h>

namespace insonate::segmentation {

/// Binary mask: 1 inside, 0 outside.
using Mask = Volume<std::uint8_t>;

/// dilate(), erode(), open() and close(): morphology with a ball of `radius_mm`, measured between voxel centers. Voxels
/// beyond the grid are unknown: they neither grow into the grid nor erode the mask.
void dilate(Mask& mask, double radius_mm, Work& work);
void erode(Mask& mask, double radius_mm, Work& work);
void open(Mask& mask, double radius_mm, Work& work);
void close(Mask& mask, double radius_mm, Work& work);

/// Adds the six face neighbors of each set voxel to the mask.
void dilateToNeighbors(Mask& mask, Work& work);

/// Sets each voxel to the majority of the 3 x 3 voxels around it in the slice.
void majorityInSlice(Mask& mask, Work& work);

}  // namespace insonate::segmentation
