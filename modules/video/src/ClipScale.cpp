#include <insonate/video/ClipScale.h>

namespace insonate {

bool hasSameGrid(const BModeImage& a, const BModeImage& b) {
  return a.width == b.width && a.height == b.height && a.pixel_mm == b.pixel_mm && a.left_mm == b.left_mm &&
         a.top_mm == b.top_mm;
}

ClipRegion regionOf(const BModeImage& image, int left_px, int top_px) {
  return {left_px, top_px, image.width, image.height, image.pixel_mm, image.left_mm, image.top_mm};
}

}  // namespace insonate
