#pragma once

#include <insonate/bench/ImageMeasures.h>
#include <insonate/ultrasound/FovFit.h>

#include <opencv2/core.hpp>

#include <vector>

namespace insonate::bench {

/// Returns the part of a gray image (`gray`, `width` columns) inside a box, which must lie in the image.
GrayImage cutOut(const std::vector<std::uint8_t>& gray, int width, const PixelBox& box);

/// Returns an image as an OpenCV matrix of bytes without copying: for reading only, valid as long as the image.
inline cv::Mat bytesOf(const GrayImage& picture) {
  return cv::Mat(picture.height, picture.width, CV_8U, const_cast<std::uint8_t*>(picture.gray.data()));
}
/// Copies an OpenCV matrix of bytes to an image.
GrayImage pictureOf(const cv::Mat& bytes);

/// Returns a quantile of values in any order, with linear interpolation between neighbors; NaN without values. `share`
/// 0 to 1.
double quantile(std::vector<double> values, double share);

}  // namespace insonate::bench
