#pragma once

#include <insonate/ultrasound/Frames.h>

namespace insonate::test {

/// Independent looks of fully developed speckle (RMS 1): complex Gaussian noise through a Gaussian point-spread
/// function whose amplitude has these widths at half maximum, in samples and scanlines.
EnvelopeFrame speckleFrame(int scanlines, int samples, int looks, double axialFwhm, double lateralFwhm, unsigned seed);

/// Grain of a square patch of an image, slow shading (a quadratic surface) removed as it is for real images.
struct Grain {
  double mean, sd, skewness;
  double axialFwhm_mm, lateralFwhm_mm;  ///< of the autocorrelation
};
Grain grainOf(const BModeImage& image, int column, int row, int size);
/// Medians over patches that cover the middle of the picture.
Grain medianGrain(const BModeImage& image, int patch);

}  // namespace insonate::test
