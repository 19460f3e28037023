#include "SlicePreview.h"

#include <insonate/views/WindowLevel.h>

#include <cmath>

namespace insonate::ui {

QImage slicePreview(const CtVolume& ct, int side, int shift_HU) {
  const auto& size = ct.geometry.size;
  const auto& axes = ct.geometry.direction.column;
  const views::WindowLevel softTissue;
  const bool mirrored = axes[0].x < 0, upsideDown = axes[1].y < 0;
  QImage slice(size[0], size[1], QImage::Format_Grayscale8);
  for (int j = 0; j < size[1]; ++j) {
    uchar* line = slice.scanLine(upsideDown ? size[1] - 1 - j : j);
    for (int i = 0; i < size[0]; ++i)
      line[mirrored ? size[0] - 1 - i : i] = softTissue.grey(ct.at(i, j, size[2] / 2) + shift_HU);
  }
  const double width_mm = size[0] * ct.geometry.spacing_mm.x, height_mm = size[1] * ct.geometry.spacing_mm.y;
  const double scale = side / std::max(width_mm, height_mm);
  return slice.scaled(std::max(1, int(std::lround(width_mm * scale))), std::max(1, int(std::lround(height_mm * scale))),
                      Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

}  // namespace insonate::ui
