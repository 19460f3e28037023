#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

namespace insonate::test {

/// 8-bit RGB, top row first.
struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;

  const std::uint8_t* at(int x, int y) const { return rgb.data() + 3 * (std::size_t(y) * width + x); }
};

/// Permitted difference between images of two machines: share of pixels that differ by more than this many gray levels
/// in any channel.
struct Tolerance {
  int steps = 24;
  double share = 0.01;
};

/// Compares with tests/golden/NAME.png. On failure the image, and one of the difference, lie under
/// Testing/golden in the build folder; with INSONATE_UPDATE_GOLDEN set, the golden image is replaced instead.
testing::AssertionResult looksLikeGolden(const Picture& picture, const std::string& name, Tolerance tolerance = {});

}  // namespace insonate::test
