#pragma once

#include <opencv2/core.hpp>

#include <array>
#include <optional>
#include <vector>

namespace insonate::fit {

/// An image prepared for the search for the field of view: light on dark, with the background's level and slow changes
/// subtracted.
struct Plate {
  cv::Mat_<float> smooth;    ///< the image blurred by 1.5 px, with the background near 0
  float threshold = 0;       ///< threshold for `smooth`, above the background's noise
  cv::Mat_<uchar> mask;      ///< 255 where `smooth` is above the threshold
  cv::Mat_<uchar> body;      ///< the mask without lines, letters and plain areas: the ultrasound image itself
  cv::Mat_<uchar> gaps;      ///< 255 if background is as close as between letters or lines
  double bodyShare = 0;      ///< share of the image that is body
  bool darkOnLight = false;  ///< true if the image was dark on light and its grays were inverted
};

/// Returns the plausible interpretations of an image as light on dark, the most probable first; empty for an image of a
/// single gray.
std::vector<Plate> platesOf(const cv::Mat_<uchar>& gray);

/// If a strip of background from top to bottom divides the body into two parts of similar size, returns one plate with
/// only the left part, and one with only the right part.
std::optional<std::array<Plate, 2>> halvesOf(const Plate& plate);

}  // namespace insonate::fit
