#pragma once

#include "realism/PictureParts.h"

namespace insonate::bench {

/// Returns the largest rectangle of pixels that are not 0; without such pixels, its size is 0.
PixelBox largestRectangle(const cv::Mat& mask);

/// Returns the smallest rectangle around all pixels that are not 0.
PixelBox boundsOf(const cv::Mat& mask);

/// Returns the image cropped to a mask, with black pixels outside the mask.
GrayImage onlyInside(const GrayImage& image, const cv::Mat& mask);

/// Resamples an image to the scale at which the readers of a blind test see it.
GrayImage atShownScale(const GrayImage& image, double pixelsPer_mm, ProbeShape probe);

}  // namespace insonate::bench
