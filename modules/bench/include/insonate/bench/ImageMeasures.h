#pragma once

#include <insonate/ultrasound/Frames.h>

namespace insonate {

/// A box of pixels: the columns `column` to `column` + `width` - 1 and the rows `row` to `row` + `height` - 1.
struct PixelBox {
  int column = 0, row = 0, width = 0, height = 0;
  bool operator==(const PixelBox&) const = default;
};

/// Statistics of the gray values 0 to 255 of the displayed image inside a box; the box must lie in the image and not be
/// empty.
struct GrayStatistics {
  double p25 = 0, p50 = 0, p75 = 0, p95 = 0, p99 = 0, mean = 0;
  double black = 0, blackUpper60 = 0;  ///< fractions of pixels with gray <= 5: in the whole box, and in its upper 60 %
  double bright = 0, saturated = 0;    ///< fractions of pixels with gray >= 200 (bright) and >= 250 (saturated)
  /// mean gray of the deepest quarter, divided by the mean gray of the second and third eighths of the depth
  double deepOverShallow = 0;
};
GrayStatistics grayStatistics(const BModeImage& image, const PixelBox& fieldOfView);

/// Properties of speckle in a patch of homogeneous tissue, after subtraction of a fitted quadratic surface (slow
/// shading).
struct SpeckleStatistics {
  /// Speckle size: axial and lateral full width at half maximum of the autocorrelation; NaN if the autocorrelation
  /// stays above one half.
  double axial_mm = 0, lateral_mm = 0;
  double mean = 0, sd = 0, skewness = 0;
};
/// Measures the speckle of a patch, which must have at least 8 x 8 pixels.
SpeckleStatistics speckleStatistics(const BModeImage& image, const PixelBox& patch);

/// Gray levels in and around a vessel's lumen, measured from a box well inside the lumen. A box more than 2.5 times as
/// wide as tall is a long-axis view. In a long-axis view, the surroundings are the bands above and below the box, and
/// the enhancement behind the lumen is not measured.
struct Lumen {
  double mean = 0, sd = 0;
  /// Mean gray of the lumen, divided by the mean gray of a ring around the box at 1.7 to 2.4 times its half axes; NaN
  /// if the ring is not in the image.
  double overSurroundings = 0;
  double nearMinusFar = 0;  ///< mean gray of the box's top fifth minus mean gray of the bottom fifth
  /// Enhancement: mean gray of the region 0.4 to 1 box heights below the box, divided by the mean gray beside this
  /// region; NaN in long-axis views.
  double belowOverSides = 0;
};
Lumen lumenOf(const BModeImage& image, const PixelBox& box);

/// Returns the gray of a bright line (bone, pleura) in a box: the median over columns of each column's brightest pixel.
double lineGray(const BModeImage& image, const PixelBox& box);
double meanGray(const BModeImage& image, const PixelBox& box);

/// Returns the mean structural similarity of two images of equal size (Wang, Bovik, Sheikh, Simoncelli, IEEE Trans.
/// Image Process. 13(4), 2004), over 8 x 8 windows every 4 pixels; 1 for equal images.
double structuralSimilarity(const BModeImage& a, const BModeImage& b);

}  // namespace insonate
