#pragma once

#include <insonate/image/Volume.h>

namespace insonate {

/// Blurs the volume in place with a Gaussian whose standard deviation is `sigma_mm` along every axis of the grid. The
/// kernel ends at three standard deviations; voxels beyond the volume count as equal to the nearest edge voxel. The
/// result is bit-identical on any number of threads.
void blurGaussian(Volume<float>& volume, double sigma_mm);

}  // namespace insonate
