#include "SlicePreview.h"

#include <insonate/views/WindowLevel.h>

#include <algorithm>
#include <cmath>

namespace insonate::ui {
namespace {

/// A slice whose pixel for the voxel (i, j) is `draw(i, j)`, turned and scaled for display.
template <class Pixel, class Draw>
QImage drawn(const VolumeGeometry& grid, int side, QImage::Format format, const Draw& draw) {
  const auto& size = grid.size;
  const auto& axes = grid.direction.column;
  const bool mirrored = axes[0].x < 0, upsideDown = axes[1].y < 0;
  QImage slice(size[0], size[1], format);
  for (int j = 0; j < size[1]; ++j) {
    auto* line = reinterpret_cast<Pixel*>(slice.scanLine(upsideDown ? size[1] - 1 - j : j));
    for (int i = 0; i < size[0]; ++i) line[mirrored ? size[0] - 1 - i : i] = draw(i, j);
  }
  const double width_mm = size[0] * grid.spacing_mm.x, height_mm = size[1] * grid.spacing_mm.y;
  const double scale = side / std::max(width_mm, height_mm);
  return slice.scaled(std::max(1, int(std::lround(width_mm * scale))), std::max(1, int(std::lround(height_mm * scale))),
                      Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

/// Index along k.
int fullestSlice(const LabelMap& labels) {
  const auto& size = labels.geometry.size;
  const auto area = std::ptrdiff_t(size[0]) * size[1];
  std::ptrdiff_t most = 0;
  int fullest = size[2] / 2;
  for (int k = 0; k < size[2]; ++k) {
    const auto first = labels.voxels.begin() + area * k;
    const auto labeled = area - std::count(first, first + area, std::uint8_t{0});
    if (labeled > most) most = labeled, fullest = k;
  }
  return fullest;
}

}  // namespace

QImage slicePreview(const CtVolume& ct, int side, int shift_HU) {
  const views::WindowLevel softTissue;
  const int k = ct.geometry.size[2] / 2;
  return drawn<uchar>(ct.geometry, side, QImage::Format_Grayscale8,
                      [&](int i, int j) { return softTissue.gray(ct.at(i, j, k) + shift_HU); });
}

QImage labelPreview(const CtVolume& ct, const LabelMap& labels, const LabelColors& colors, int side) {
  const views::WindowLevel softTissue;
  const int k = fullestSlice(labels);
  return drawn<QRgb>(ct.geometry, side, QImage::Format_RGB32, [&](int i, int j) {
    const int gray = softTissue.gray(ct.at(i, j, k));
    const std::uint8_t label = labels.at(i, j, k);
    if (label == 0) return qRgb(gray, gray, gray);
    const LabelColor color = caseLabelColor(colors, label);
    return qRgb((gray + color[0]) / 2, (gray + color[1]) / 2, (gray + color[2]) / 2);
  });
}

}  // namespace insonate::ui
