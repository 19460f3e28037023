#pragma once

namespace insonate::views {

/// The part of the imaging plane to show, probe frame mm; low < high.
struct PictureBounds {
  double minLateral_mm = -20, maxLateral_mm = 20, minAxial_mm = 0, maxAxial_mm = 40;
};

/// Position of that part on a display of square pixels.
struct PicturePlacement {
  double px_per_mm = 10, left_px = 0, top_px = 0, right_px = 0, bottom_px = 0;
};

/// Largest placement with room for the depth scale and the bars beside it; `scale` is device pixels to a logical one.
/// Displays of one size place the same bounds at the same pixels.
PicturePlacement placementOf(const PictureBounds& bounds, int width_px, int height_px, double scale);

}  // namespace insonate::views
