#pragma once

#include <opencv2/core.hpp>

#include <array>
#include <optional>
#include <vector>

namespace insonate::fit {

/// An image made ready for the search: light on dark, the ground's level and slow changes taken off.
struct Plate {
  cv::Mat_<float> smooth;    ///< blurred by 1.5 px, ground near 0
  float threshold = 0;       ///< of `smooth`, above the ground's noise
  cv::Mat_<uchar> mask;      ///< 255 above the threshold
  cv::Mat_<uchar> body;      ///< what is left of it without lines, letters and plain areas
  cv::Mat_<uchar> gaps;      ///< 255 where ground is within a letter's or a line's distance
  double bodyShare = 0;      ///< of the image
  bool darkOnLight = false;  ///< the image's grays were turned round
};

/// The plausible ways to read an image, the likeliest first; none for an image of one gray.
std::vector<Plate> platesOf(const cv::Mat_<uchar>& grey);

/// If ground from top to bottom divides the body in two parts of a size: the plate with its left part alone, and with
/// its right one.
std::optional<std::array<Plate, 2>> halvesOf(const Plate& plate);

}  // namespace insonate::fit
