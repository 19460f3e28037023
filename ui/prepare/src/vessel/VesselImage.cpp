#include "VesselImage.h"

#include "../model/PrepareModel.h"
#include "../model/SliceSettings.h"
#include "../model/StructureAppearance.h"

#include <algorithm>
#include <array>

namespace insonate::prepare {
namespace {

/// Shares of a label's color in a pixel inside the label and in a pixel at its edge.
struct Share {
  double inside = 0, edge = 0;
};

/// Shares as in the slices (views/MprView).
std::array<Share, 256> sharesOf(const PrepareModel& shared) {
  constexpr double kEdgeAlone = 0.9;
  std::array<Share, 256> shares{};
  const SliceSettings& slices = shared.slices;
  if (!slices.labelsShown()) return shares;
  const views::LabelStyle& style = slices.labelStyle();
  for (int label = 1; label < 256; ++label) {
    const StructureLook& look = shared.appearance.look(std::uint8_t(label));
    if (!look.visible) continue;
    Share& share = shares[std::size_t(label)];
    share.inside = style.fill ? look.onSlices * slices.labelOpacity() : 0;
    const double edge = style.fill ? std::min(1.0, 2 * share.inside) : look.onSlices * kEdgeAlone;
    share.edge = style.outline ? edge : share.inside;
  }
  return shares;
}

/// Tells whether a pixel of a label is at the border of another label. Comparing with one neighbor on each axis makes
/// the line one pixel wide.
bool isEdge(const ResampledImage& image, int x, int y) {
  const std::size_t pixel = std::size_t(y) * std::size_t(image.size.width) + std::size_t(x);
  const std::uint8_t label = image.labels[pixel];
  return (x + 1 < image.size.width && image.labels[pixel + 1] != label) ||
         (y + 1 < image.size.height && image.labels[pixel + std::size_t(image.size.width)] != label);
}

}  // namespace

QImage drawnAsSlice(const ResampledImage& image, const PrepareModel& shared) {
  const std::array<Share, 256> shares = sharesOf(shared);
  const views::WindowLevel window = shared.slices.windowLevel();
  QImage drawn(image.size.width, image.size.height, QImage::Format_RGB32);
  std::size_t pixel = 0;
  for (int y = 0; y < image.size.height; ++y) {
    auto* row = reinterpret_cast<QRgb*>(drawn.scanLine(y));
    for (int x = 0; x < image.size.width; ++x, ++pixel) {
      if (image.hu[pixel] == ResampledImage::kOutside) {
        row[x] = qRgb(0, 0, 0);
        continue;
      }
      const int gray = window.gray(image.hu[pixel]);
      const std::uint8_t label = image.labels[pixel];
      const Share& share = shares[label];
      const double part = share.inside == share.edge || !isEdge(image, x, y) ? share.inside : share.edge;
      const views::Color color = shared.appearance.look(label).color;
      const auto mixed = [gray, part](int of) { return int(gray + part * (of - gray)); };
      row[x] = qRgb(mixed(color.red), mixed(color.green), mixed(color.blue));
    }
  }
  return drawn;
}

}  // namespace insonate::prepare
