#pragma once

#include <insonate/core/Vec3.h>

namespace insonate {

/// Region that the live image shows, in the probe's frame. In the plane y = 0 it is a rectangle, or a fan about an apex
/// `faceRadius_mm` behind the face. Perpendicular to the plane its thickness is that of the beam, according to SliceLaw
/// (insonate/ultrasound/PointSpread.h).
struct PictureField {
  double width_mm = 0;      ///< width of the rectangle
  double fanAngle_deg = 0;  ///< full angle; 0: a rectangle
  double faceRadius_mm = 0;
  double sliceHalf_mm = 0;               ///< half the minimum slice thickness (FWHM); 0: this attempt has no image
  double elevationFocus_mm = 0;          ///< depth of the minimum thickness, below the face
  double elevationDivergence = 0;        ///< growth of the thickness per mm, in front of that depth; 0: unknown or none
  double elevationDivergenceBehind = 0;  ///< growth of the thickness per mm, behind that depth

  bool operator==(const PictureField&) const = default;
};

/// Maximum distance from the plane at which the image still shows a needle, at this range from the face. It is one
/// slice thickness, hypot(minimum thickness, divergence * distance from the depth of minimum thickness). For a Gaussian
/// beam an echo at this distance is reduced by about 20 log10(16) = 24 dB, which is the excess of a needle at 45
/// degrees over speckle (ultrasound/README.md, "Needle").
double shownOffPlane_mm(const PictureField& field, double range_mm);

/// Tells whether a live image of this depth shows a needle's tip at a point of the probe's frame.
bool shows(const PictureField& field, double depth_mm, Vec3 tip_probe);

}  // namespace insonate
