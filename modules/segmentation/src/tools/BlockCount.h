#pragma once

#include "Morphology.h"

namespace insonate::segmentation {

/// Sets each voxel to the majority of the voxels within `radius_mm` along every axis; at the grid's edge, of those
/// that exist.
void majorityInBlock(Mask& mask, double radius_mm, Work& work);

}  // namespace insonate::segmentation
