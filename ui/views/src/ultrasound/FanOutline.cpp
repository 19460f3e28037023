#include "FanOutline.h"

#include <insonate/ultrasound/BeamGrid.h>

namespace insonate::views {

std::vector<PlanePoint> fieldOfViewStrip(const Probe& probe, const ImagingSettings& settings) {
  const BeamGrid grid(probe, settings);
  const int columns = probe.shape == ProbeShape::Linear ? 1 : 48;
  std::vector<PlanePoint> strip;
  for (int column = 0; column <= columns; ++column) {
    // The field of view ends half a scanline beyond the first and the last one.
    const double scanline = -0.5 + double(grid.scanlines()) * column / columns;
    const Vec3 face = grid.origin(scanline), depth = face + grid.direction(scanline) * settings.depth_mm;
    strip.push_back({face.x, face.z});
    strip.push_back({depth.x, depth.z});
  }
  return strip;
}

std::vector<PlanePoint> fieldOfViewOutline(const Probe& probe, const ImagingSettings& settings) {
  const std::vector<PlanePoint> strip = fieldOfViewStrip(probe, settings);
  std::vector<PlanePoint> outline;
  for (std::size_t k = 0; k < strip.size(); k += 2) outline.push_back(strip[k]);
  for (std::size_t k = strip.size(); k > 0; k -= 2) outline.push_back(strip[k - 1]);
  return outline;
}

}  // namespace insonate::views
