#pragma once

#include "Morphology.h"

namespace insonate::segmentation {

/// Each voxel becomes what most voxels within `radius_mm` along every axis are. At the grid's edge, those that there
/// are.
void majorityInBlock(Mask& mask, double radius_mm, Work& work);

}  // namespace insonate::segmentation
