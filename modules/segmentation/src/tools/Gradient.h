#pragma once

#include "Work.h"

#include <insonate/image/VoxelBox.h>

namespace insonate::segmentation {

/// The CT in a box, blurred with a Gaussian. What lies beyond the box does not count.
Volume<float> blurred(const CtVolume& ct, const VoxelBox& box, double sigma_mm);

/// Gradient magnitude of the blurred CT, HU per millimeter, by central differences.
Volume<float> gradientMagnitude(const CtVolume& ct, const VoxelBox& box, double sigma_mm, Work& work);

}  // namespace insonate::segmentation
