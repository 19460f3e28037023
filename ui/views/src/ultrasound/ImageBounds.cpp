#include "PictureFrame.h"

#include <insonate/views/ImageBounds.h>

#include <algorithm>
#include <cmath>

namespace insonate::views {

ImagePlacement placementOf(const ImageBounds& bounds, int width_px, int height_px, double scale) {
  const double left = kFrameLeft * scale, right = kFrameRight * scale;
  const double top = kFrameTop * scale, bottom = kFrameBottom * scale;
  const double wide_mm = std::max(1e-3, bounds.maxLateral_mm - bounds.minLateral_mm);
  const double deep_mm = std::max(1e-3, bounds.maxAxial_mm - bounds.minAxial_mm);
  const double room_x = std::max(8.0, width_px - left - right), room_y = std::max(8.0, height_px - top - bottom);
  ImagePlacement place;
  place.px_per_mm = std::min(room_x / wide_mm, room_y / deep_mm);
  place.left_px = std::round(left + 0.5 * (room_x - wide_mm * place.px_per_mm));
  place.top_px = std::round(top + 0.5 * (room_y - deep_mm * place.px_per_mm));
  place.right_px = place.left_px + wide_mm * place.px_per_mm;
  place.bottom_px = place.top_px + deep_mm * place.px_per_mm;
  return place;
}

}  // namespace insonate::views
