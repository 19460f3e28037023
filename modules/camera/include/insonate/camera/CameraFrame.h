#pragma once

#include <cstdint>
#include <vector>

namespace insonate {

/// A point in an image, pixels. Pixel (i, j) covers i to i+1 and j to j+1, so that its center is at i + 0.5, j + 0.5;
/// x points right, y down.
struct FramePoint {
  double x = 0, y = 0;
};

/// A rectangle of whole pixels.
struct FrameBox {
  int left = 0, top = 0, width = 0, height = 0;
};

/// A gray image that another object owns: rows of `stride` bytes from the top, 0 (black) to 255.
struct GrayView {
  const std::uint8_t* pixels = nullptr;
  int width = 0, height = 0, stride = 0;
};

/// One gray image of a camera, with the time of its exposure.
struct CameraFrame {
  int width = 0, height = 0;
  std::vector<std::uint8_t> pixels;  ///< width * height values from the top left, 0 (black) to 255
  std::int64_t time_ns = 0;          ///< middle of the exposure, CLOCK_MONOTONIC
  std::int64_t exposure_ns = 0;      ///< duration of the exposure; 0: unknown

  GrayView view() const { return {pixels.data(), width, height, width}; }
};

}  // namespace insonate
