#pragma once

#include <insonate/bench/PictureMeasures.h>
#include <insonate/simulator/Imager.h>

#include <vector>

namespace insonate::bench {

/// Selection of pixels of an image.
struct PixelMask {
  int width = 0, height = 0;
  std::vector<std::uint8_t> chosen;  ///< [row][column], 0 or 1
  bool at(int column, int row) const { return chosen[std::size_t(row) * width + column] != 0; }
};

/// Label of each pixel of the displayed image.
class LabelPicture {
 public:
  static constexpr std::uint8_t kUnknown = 255;  ///< outside the field of view, or without good contact

  /// The scene must have the setup's tissues, with marks (see withMarks()).
  LabelPicture(const AcousticScene& scene, const ImagingSetup& setup, const Transform& patientFromProbe);

  PixelMask maskOf(const std::vector<std::uint8_t>& labels) const;
  double pixel_mm() const { return pixel_mm_; }
  /// Bounding box of the pixels inside the field of view.
  PictureBox fieldOfView() const { return fieldOfView_; }

 private:
  int width_, height_;
  double pixel_mm_ = 0;
  PictureBox fieldOfView_;
  std::vector<std::uint8_t> label_;
};

/// Removes pixels whose square of this half width contains a pixel outside the mask.
PixelMask eroded(const PixelMask& mask, int pixels);
/// Connected components (4 neighbors) of at least this many pixels, largest first.
std::vector<PixelMask> parts(const PixelMask& mask, int leastPixels);
/// The largest box inside the mask that is no larger than the given size; empty if there is none.
PictureBox largestBox(const PixelMask& mask, int mostWidth, int mostHeight);

}  // namespace insonate::bench
