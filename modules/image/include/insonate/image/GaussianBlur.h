#pragma once

#include <insonate/image/Volume.h>

namespace insonate {

/// Blurs in place with a Gaussian of the given standard deviation in mm along every axis of the grid (kernel cut at
/// three standard deviations, edges repeated). The result is bit-identical on any number of threads.
void blurGaussian(Volume<float>& volume, double sigma_mm);

}  // namespace insonate
