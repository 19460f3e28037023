#pragma once

#include "realism/ReaderSheet.h"

#include <insonate/bench/RealismBench.h>

namespace insonate::bench {

/// One image of a blind test in which readers distinguish real from simulated images.
struct BlindImage {
  const SourceImage* image = nullptr;
  bool simulated = false;
};

/// Real and simulated images, divided into the images of a blind test, in an order that the seed determines, and images
/// that cannot be in the test, since only one of the sets has images of their kind (probe, still or clip).
struct BlindImages {
  std::vector<BlindImage> matched, unmatched;
};
BlindImages blindImages(const RealismBench& bench);

/// Name of the file, or of the folder of a clip's frames, for image `n` (from 0): "003".
std::string numbered(std::size_t n);
/// Returns the names of the files of image `n`, relative to the folder of writeImages().
SheetItem filesOf(const BlindImage& image, std::size_t n);

/// Writes images as numbered JPEG files, and clips as folders of frames. Returns each image as readers see it; for a
/// clip, the middle frame.
Result<std::vector<GrayImage>> writeImages(const std::vector<BlindImage>& images, const std::filesystem::path& folder);

/// Writes the images, sheets and instructions of a blind test; nothing in them reveals which images are real.
Result<void> writeBlindSet(const std::vector<BlindImage>& images, const std::filesystem::path& folder);

/// Encodes a gray image as JPEG. `quality` 1 to 100.
std::string jpegOf(const GrayImage& picture, int quality);

}  // namespace insonate::bench
