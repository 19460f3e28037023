#include "FanMask.h"

#include <algorithm>
#include <cmath>

namespace insonate::views {

void FanMask::apply(std::span<const DisplayPoint> outline, int width_px, int height_px, std::span<std::uint8_t> rgb) {
  for (int row = 0; row < height_px; ++row) {
    const double y = row + 0.5;
    crossings_.clear();
    for (std::size_t k = 0; k < outline.size(); ++k) {
      const DisplayPoint a = outline[k], b = outline[(k + 1) % outline.size()];
      if ((a.y <= y) != (b.y <= y)) crossings_.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
    }
    std::ranges::sort(crossings_);
    // A pixel is inside if its center is between the first and the second crossing, the third and the fourth, and so
    // on.
    std::uint8_t* line = rgb.data() + std::size_t(3) * row * width_px;
    int black = 0;
    const auto column = [&](double x) { return std::clamp(int(std::lround(x)), 0, width_px); };
    for (std::size_t k = 0; k + 1 < crossings_.size(); k += 2) {
      const int first = column(crossings_[k]), end = column(crossings_[k + 1]);
      std::fill(line + 3 * black, line + 3 * std::max(black, first), std::uint8_t{0});
      black = std::max(black, end);
    }
    std::fill(line + 3 * black, line + 3 * width_px, std::uint8_t{0});
  }
}

}  // namespace insonate::views
