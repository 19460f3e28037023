#pragma once

#include <insonate/bench/RealismBench.h>

namespace insonate::bench {

/// One image of a blind test in which readers tell real from simulated images.
struct BlindImage {
  const SourceImage* image = nullptr;
  bool simulated = false;
};

/// Returns all real and simulated images in a random order, which the seed of `bench` determines.
std::vector<BlindImage> shuffled(const RealismBench& bench);

/// Writes the images, sheets and instructions of a blind test; nothing in them reveals which images are real.
Result<void> writeBlindSet(const std::vector<BlindImage>& images, const std::filesystem::path& folder);

/// Encodes a gray image as JPEG. `quality` 1 to 100.
std::string jpegOf(const GreyPicture& picture, int quality);

}  // namespace insonate::bench
