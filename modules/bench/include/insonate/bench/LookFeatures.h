#pragma once

#include <insonate/ultrasound/FovFit.h>

#include <string>
#include <vector>

namespace insonate {

/// A number that describes how an ultrasound image looks, without labels.
struct LookFeature {
  std::string name;
  double value = 0;  ///< NaN where the image has nothing to measure
};

/// Pixels per mm to which images are brought before they are measured.
inline constexpr double kLookPixelsPer_mm = 10;

/// The image at 10 pixels per mm, cut to its upper `depth_mm`. Fails on an image that is smaller than 10 x 10 mm or
/// whose scale is not in 1 to 100 pixels per mm.
Result<GreyPicture> atLookScale(const GreyPicture& image, double pixelsPer_mm, double depth_mm = 30);

/// Features of the inside of a field of view of a linear probe, without text, as atLookScale() returns it: gray
/// percentiles, local contrast, lateral and axial detail by spatial frequency, edges, correlation of ridges (skin,
/// fascia, vessel walls) along the face, length of ridges, and by depth (0 to 10, 10 to 20, 20 to 30 mm) the full width
/// of the detail's autocorrelation at half its height, axial and lateral, and the pixel noise.
std::vector<LookFeature> lookFeatures(const GreyPicture& image);

}  // namespace insonate
