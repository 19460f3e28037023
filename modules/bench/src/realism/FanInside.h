#pragma once

#include "realism/PictureParts.h"

namespace insonate::bench {

/// Returns the largest rectangle of pixels that are not 0; without such pixels, its size is 0.
PixelBox largestRectangle(const cv::Mat& mask);

/// Returns the smallest rectangle around all pixels that are not 0.
PixelBox boundsOf(const cv::Mat& mask);

/// An image whose pixels outside a mask are black, cropped to the mask.
GreyPicture onlyInside(const GreyPicture& image, const cv::Mat& mask);

/// Resamples to the scale that readers see.
GreyPicture atShownScale(const GreyPicture& image, double pixelsPer_mm, ProbeShape probe);

}  // namespace insonate::bench
