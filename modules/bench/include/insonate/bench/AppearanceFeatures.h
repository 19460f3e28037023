#pragma once

#include <insonate/ultrasound/FovFit.h>

#include <string>
#include <vector>

namespace insonate {

/// A number that describes the appearance of an ultrasound image. It is computed from the image alone, without labels.
struct AppearanceFeature {
  std::string name;
  double value = 0;  ///< value of the feature; NaN if the image does not allow the measurement
};

/// Resolution in pixels per mm to which images are resampled before they are measured.
inline constexpr double kFeaturePixelsPer_mm = 10;

/// Resamples an image to 10 pixels per mm and crops it to the upper `depth_mm`. Fails if the image is smaller than 10 x
/// 10 mm or if its scale is not in 1 to 100 pixels per mm.
Result<GrayImage> atFeatureScale(const GrayImage& image, double pixelsPer_mm, double depth_mm = 30);

/// Measures a rectangle inside a field of view, without text, as atFeatureScale() returns it. Features of the whole
/// rectangle: gray percentiles, local contrast, lateral and axial detail by spatial frequency, edges, correlation of
/// ridges (skin, fascia, vessel walls) along the face, and length of ridges. Features of each depth range (0 to 10, 10
/// to 20, 20 to 30 mm): axial and lateral full width at half maximum of the autocorrelation of the detail, and pixel
/// noise.
std::vector<AppearanceFeature> appearanceFeatures(const GrayImage& image);

/// Measures motion in a clip of kClipFrames frames of equal size. Features: correlation of the fine detail between
/// frames 1/30 s and 1/3 s apart; mean change of gray from frame to frame, relative to the mean gray; standard
/// deviation of the mean gray of frames, relative to the mean gray. All are NaN for stills.
std::vector<AppearanceFeature> motionFeatures(const std::vector<GrayImage>& frames);

}  // namespace insonate
