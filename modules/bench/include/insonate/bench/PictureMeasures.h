#pragma once

#include <insonate/ultrasound/Frames.h>

namespace insonate {

/// Pixels column .. column + width - 1, row .. row + height - 1.
struct PictureBox {
  int column = 0, row = 0, width = 0, height = 0;
  bool operator==(const PictureBox&) const = default;
};

/// Grey values 0..255 of the displayed image inside a box; the box must lie in the image and not be empty.
struct GreyShares {
  double p25 = 0, p50 = 0, p75 = 0, p95 = 0, p99 = 0, mean = 0;
  double black = 0, blackUpper60 = 0;  ///< shares of gray <= 5, whole and upper 60 %
  double bright = 0, saturated = 0;    ///< shares of gray >= 200, >= 250
  double deepOverShallow = 0;          ///< mean of the deepest quarter over that of the second eighth and third eighth
};
GreyShares greyShares(const BModeImage& image, const PictureBox& fieldOfView);

/// Speckle in a patch of even tissue, after a quadratic surface has been taken off: slow shading is not grain.
struct Grain {
  double axial_mm = 0,
         lateral_mm = 0;  ///< full width of the autocorrelation at half its height; NaN where it stays above
  double mean = 0, sd = 0, skewness = 0;
};
/// The box must have at least 8 x 8 pixels.
Grain grainOf(const BModeImage& image, const PictureBox& patch);

/// The lumen of a vessel, from a box well inside it. Boxes more than 2.5 times as wide as tall are long-axis views:
/// their surroundings are bands above and below, and enhancement behind them is not measured.
struct Lumen {
  double mean = 0, sd = 0;
  double overSurroundings = 0;  ///< ring of 1.7 to 2.4 times the box's half axes; NaN where none is in the image
  double nearMinusFar = 0;      ///< top fifth minus bottom fifth
  double belowOverSides = 0;    ///< 0.4 to 1 box heights below; NaN in long-axis views
};
Lumen lumenOf(const BModeImage& image, const PictureBox& box);

/// Median over the columns of their brightest pixel.
double lineGrey(const BModeImage& image, const PictureBox& box);
double meanGrey(const BModeImage& image, const PictureBox& box);

/// Mean structural similarity of two images of equal size (Wang, Bovik, Sheikh, Simoncelli, IEEE Trans. Image
/// Process. 13(4), 2004), over 8 x 8 windows every 4 pixels; 1 for equal pictures.
double structuralSimilarity(const BModeImage& a, const BModeImage& b);

}  // namespace insonate
