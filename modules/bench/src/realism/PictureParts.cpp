#include "realism/PictureParts.h"

#include <algorithm>
#include <limits>

namespace insonate::bench {

GrayImage cutOut(const std::vector<std::uint8_t>& gray, int width, const PixelBox& box) {
  GrayImage cut{box.width, box.height, {}};
  cut.gray.reserve(std::size_t(box.width) * std::size_t(box.height));
  for (int y = box.row; y < box.row + box.height; ++y) {
    const auto row = gray.begin() + std::ptrdiff_t(y) * width + box.column;
    cut.gray.insert(cut.gray.end(), row, row + box.width);
  }
  return cut;
}

GrayImage pictureOf(const cv::Mat& bytes) {
  const cv::Mat whole = bytes.isContinuous() ? bytes : bytes.clone();
  return {whole.cols, whole.rows, {whole.data, whole.data + whole.total()}};
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::ranges::sort(values);
  const double at = share * double(values.size() - 1);
  const auto low = std::size_t(at);
  const std::size_t high = std::min(low + 1, values.size() - 1);
  return values[low] + (values[high] - values[low]) * (at - double(low));
}

}  // namespace insonate::bench
