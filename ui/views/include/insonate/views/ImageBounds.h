#pragma once

namespace insonate::views {

/// Rectangle of the image plane that a view shows, probe frame; each minimum is below its maximum.
struct ImageBounds {
  double minLateral_mm = -20, maxLateral_mm = 20, minAxial_mm = 0, maxAxial_mm = 40;
};

/// Position and scale at which ImageBounds are shown on a display with square pixels.
struct ImagePlacement {
  double px_per_mm = 10, left_px = 0, top_px = 0, right_px = 0, bottom_px = 0;
};

/// Returns the largest placement that leaves space for the depth scale and the bars beside the image. `scale`: device
/// pixels per logical pixel. On displays of the same size, the same bounds have the same placement.
ImagePlacement placementOf(const ImageBounds& bounds, int width_px, int height_px, double scale);

}  // namespace insonate::views
