#pragma once

#include <insonate/bench/RealismBench.h>

namespace insonate::bench {

/// One image of a blind test.
struct BlindImage {
  const SourceImage* image = nullptr;
  bool simulated = false;
};

/// Returns all images of both sets in an order that the seed determines.
std::vector<BlindImage> shuffled(const RealismBench& bench);

/// Writes images, sheets and instructions; nothing in them reveals which images are real.
Result<void> writeBlindSet(const std::vector<BlindImage>& images, const std::filesystem::path& folder);

/// Encodes a gray image as JPEG. `quality` 1 to 100.
std::string jpegOf(const GreyPicture& picture, int quality);

}  // namespace insonate::bench
