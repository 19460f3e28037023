#pragma once

#include <insonate/views/Input.h>

#include <cstdint>
#include <span>
#include <vector>

namespace insonate::views {

/// Makes all pixels outside an outline black. Reuses its buffers from call to call.
class FanMask {
 public:
  /// `outline` is a closed polygon in display pixels; `rgb` has width * height * 3 bytes, top row first.
  void apply(std::span<const DisplayPoint> outline, int width_px, int height_px, std::span<std::uint8_t> rgb);

 private:
  std::vector<double> crossings_;
};

}  // namespace insonate::views
