#pragma once

#include "Work.h"

#include <insonate/image/VoxelBox.h>

namespace insonate::segmentation {

/// Returns the CT in a box, blurred with a Gaussian; voxels beyond the box are not used.
Volume<float> blurred(const CtVolume& ct, const VoxelBox& box, double sigma_mm);

/// Returns the gradient magnitude of the blurred CT, HU per millimeter, by central differences.
Volume<float> gradientMagnitude(const CtVolume& ct, const VoxelBox& box, double sigma_mm, Work& work);

}  // namespace insonate::segmentation
