#pragma once

#include <insonate/bench/PictureMeasures.h>
#include <insonate/ultrasound/FovFit.h>

#include <opencv2/core.hpp>

#include <vector>

namespace insonate::bench {

/// The part of an image of `width` columns that a box covers; the box must lie in the picture.
GreyPicture cutOut(const std::vector<std::uint8_t>& grey, int width, const PictureBox& box);

/// The image's own bytes, to be read only; valid as long as the picture.
inline cv::Mat bytesOf(const GreyPicture& picture) {
  return cv::Mat(picture.height, picture.width, CV_8U, const_cast<std::uint8_t*>(picture.grey.data()));
}
/// A copy of a matrix of bytes.
GreyPicture pictureOf(const cv::Mat& bytes);

/// Quantile of values in any order, between neighbors by linear interpolation; NaN of nothing. `share` 0..1.
double quantile(std::vector<double> values, double share);

}  // namespace insonate::bench
