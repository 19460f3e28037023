#pragma once

#include <opencv2/core.hpp>

#include <array>
#include <optional>
#include <vector>

namespace insonate::fit {

/// An image prepared for the search: light on dark, with the background's level and slow changes subtracted.
struct Plate {
  cv::Mat_<float> smooth;    ///< blurred by 1.5 px, background near 0
  float threshold = 0;       ///< threshold for `smooth`, above the background's noise
  cv::Mat_<uchar> mask;      ///< 255 above the threshold
  cv::Mat_<uchar> body;      ///< the mask without lines, letters and plain areas
  cv::Mat_<uchar> gaps;      ///< 255 if background is within the distance of a letter or a line
  double bodyShare = 0;      ///< share of the image that is body
  bool darkOnLight = false;  ///< the image's grays were inverted
};

/// Returns the plausible interpretations of an image, the most probable first; empty for an image of a single gray.
std::vector<Plate> platesOf(const cv::Mat_<uchar>& grey);

/// If background from top to bottom divides the body into two parts of similar size, returns the plate with only its
/// left part, and with only its right part.
std::optional<std::array<Plate, 2>> halvesOf(const Plate& plate);

}  // namespace insonate::fit
