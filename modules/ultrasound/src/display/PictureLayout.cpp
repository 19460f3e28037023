#include "PictureLayout.h"

#include <insonate/ultrasound/Display.h>

#include <algorithm>

namespace insonate {
namespace display {

BModeImage pictureLayout(const BeamGrid& grid, const ImagingSettings& settings) {
  const double width_mm = grid.maxLateral_mm() - grid.minLateral_mm();
  const double height_mm = grid.maxAxial_mm() - grid.minAxial_mm();
  BModeImage image;
  image.width = settings.width, image.height = settings.height;
  image.pixel_mm = std::max(width_mm / settings.width, height_mm / settings.height);
  image.left_mm = 0.5 * (grid.minLateral_mm() + grid.maxLateral_mm()) - 0.5 * (settings.width - 1) * image.pixel_mm;
  image.top_mm = 0.5 * (grid.minAxial_mm() + grid.maxAxial_mm()) - 0.5 * (settings.height - 1) * image.pixel_mm;
  return image;
}

}  // namespace display

std::vector<std::uint8_t> fieldOfViewMask(const Probe& probe, const ImagingSettings& settings) {
  const BeamGrid grid(probe, settings);
  const BModeImage layout = display::pictureLayout(grid, settings);
  std::vector<std::uint8_t> mask;
  mask.reserve(std::size_t(layout.width) * layout.height);
  for (int row = 0; row < layout.height; ++row)
    for (int column = 0; column < layout.width; ++column)
      mask.push_back(
          grid.locate(layout.left_mm + column * layout.pixel_mm, layout.top_mm + row * layout.pixel_mm).inside);
  return mask;
}

}  // namespace insonate
