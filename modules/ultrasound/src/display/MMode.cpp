#include <insonate/ultrasound/BeamGrid.h>
#include <insonate/ultrasound/MMode.h>

#include <algorithm>
#include <cmath>

namespace insonate {

void lineOverTime(const BModeImage& image, const Probe& probe, const ImagingSettings& settings, double across,
                  std::span<std::uint8_t> gray) {
  std::ranges::fill(gray, std::uint8_t{0});
  if (image.width < 2 || image.height < 2) return;
  const BeamGrid grid(probe, settings);
  const double scanline = across * grid.scanlines() - 0.5;
  const Vec3 face = grid.origin(scanline), beam = grid.direction(scanline);
  // A steered scanline is longer than the image is deep.
  const double longest_mm = grid.range_mm(grid.samples() - 0.5);
  for (std::size_t row = 0; row < gray.size(); ++row) {
    const Vec3 at = face + beam * (longest_mm * (double(row) + 0.5) / double(gray.size()));
    const double x = (at.x - image.left_mm) / image.pixel_mm, y = (at.z - image.top_mm) / image.pixel_mm;
    if (x < 0 || y < 0 || x > image.width - 1 || y > image.height - 1) continue;
    const int column = std::min(static_cast<int>(x), image.width - 2),
              line = std::min(static_cast<int>(y), image.height - 2);
    const double s = x - column, t = y - line;
    const std::uint8_t* const above = image.gray.data() + std::size_t(line) * image.width + column;
    const std::uint8_t* const below = above + image.width;
    const double level = (1 - t) * ((1 - s) * above[0] + s * above[1]) + t * ((1 - s) * below[0] + s * below[1]);
    gray[row] = static_cast<std::uint8_t>(std::lround(level));
  }
}

}  // namespace insonate
