#include "realism/FanInside.h"

#include <insonate/bench/SourceImage.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <vector>

namespace insonate::bench {

/// For each row, the heights of the columns of set pixels that end in it make a histogram, in which a stack finds the
/// largest rectangle.
PixelBox largestRectangle(const cv::Mat& mask) {
  PixelBox best{};
  std::vector<int> height(std::size_t(mask.cols) + 1, 0), left;
  for (int y = 0; y < mask.rows; ++y) {
    const auto* row = mask.ptr<std::uint8_t>(y);
    for (int x = 0; x < mask.cols; ++x) height[std::size_t(x)] = row[x] ? height[std::size_t(x)] + 1 : 0;
    left.clear();
    for (int x = 0; x <= mask.cols; ++x) {  // the last height is 0 and closes all rectangles
      while (!left.empty() && height[std::size_t(left.back())] >= height[std::size_t(x)]) {
        const int tall = height[std::size_t(left.back())];
        left.pop_back();
        const int from = left.empty() ? 0 : left.back() + 1;
        if (tall * (x - from) > best.width * best.height) best = {from, y - tall + 1, x - from, tall};
      }
      left.push_back(x);
    }
  }
  return best;
}

PixelBox boundsOf(const cv::Mat& mask) {
  const cv::Rect box = cv::boundingRect(mask);
  return {box.x, box.y, box.width, box.height};
}

GrayImage onlyInside(const GrayImage& image, const cv::Mat& mask) {
  cv::Mat inside = cv::Mat::zeros(mask.size(), CV_8U);
  bytesOf(image).copyTo(inside, mask);
  const PixelBox box = boundsOf(mask);
  return pictureOf(inside(cv::Rect(box.column, box.row, box.width, box.height)));
}

GrayImage atShownScale(const GrayImage& image, double pixelsPer_mm, ProbeShape probe) {
  const double factor = shownPixelsPer_mm(probe) / pixelsPer_mm;
  cv::Mat scaled;
  cv::resize(bytesOf(image), scaled, {}, factor, factor, factor < 1 ? cv::INTER_AREA : cv::INTER_CUBIC);
  return pictureOf(scaled);
}

}  // namespace insonate::bench
