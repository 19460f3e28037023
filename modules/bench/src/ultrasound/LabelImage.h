#pragma once

#include <insonate/bench/ImageMeasures.h>
#include <insonate/simulator/Imager.h>

#include <vector>

namespace insonate::bench {

/// Mask of selected pixels of an image.
struct PixelMask {
  int width = 0, height = 0;
  std::vector<std::uint8_t> chosen;  ///< 0 or 1 for each pixel, [row][column]
  bool at(int column, int row) const { return chosen[std::size_t(row) * width + column] != 0; }
};

/// Map of the tissue label of each pixel of a simulated B-mode image.
class LabelImage {
 public:
  static constexpr std::uint8_t kUnknown = 255;  ///< pixel outside the field of view, or below poor probe contact

  /// Renders the map at a pose. The scene must have the setup's tissues changed by withMarks().
  LabelImage(const AcousticScene& scene, const ImagingSetup& setup, const Transform& patientFromProbe);

  PixelMask maskOf(const std::vector<std::uint8_t>& labels) const;
  double pixel_mm() const { return pixel_mm_; }
  /// Returns the bounding box of the pixels inside the field of view.
  PixelBox fieldOfView() const { return fieldOfView_; }

 private:
  int width_, height_;
  double pixel_mm_ = 0;
  PixelBox fieldOfView_;
  std::vector<std::uint8_t> label_;
};

/// Returns the mask eroded by a square with half width `pixels`.
PixelMask eroded(const PixelMask& mask, int pixels);
/// Returns the connected components (4 neighbors) of a mask with at least `minPixels` pixels, largest first.
std::vector<PixelMask> parts(const PixelMask& mask, int minPixels);
/// Returns the largest box inside the mask, limited to `maxWidth` x `maxHeight`; empty if there is none.
PixelBox largestBox(const PixelMask& mask, int maxWidth, int maxHeight);

}  // namespace insonate::bench
