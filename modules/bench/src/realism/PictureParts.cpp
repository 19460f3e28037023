#include "realism/PictureParts.h"

#include <algorithm>
#include <limits>

namespace insonate::bench {

GreyPicture cutOut(const std::vector<std::uint8_t>& grey, int width, const PixelBox& box) {
  GreyPicture cut{box.width, box.height, {}};
  cut.grey.reserve(std::size_t(box.width) * std::size_t(box.height));
  for (int y = box.row; y < box.row + box.height; ++y) {
    const auto row = grey.begin() + std::ptrdiff_t(y) * width + box.column;
    cut.grey.insert(cut.grey.end(), row, row + box.width);
  }
  return cut;
}

GreyPicture pictureOf(const cv::Mat& bytes) {
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
