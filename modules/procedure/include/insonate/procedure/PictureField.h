#pragma once

#include <insonate/core/Vec3.h>

namespace insonate {

/// Region that the live image shows, in the probe's frame. In the plane, y = 0, it is a rectangle, or a fan about an
/// apex `faceRadius_mm` behind the face. Perpendicular to the plane it is as thick as the beam, by the slice's law
/// (SliceLaw, insonate/ultrasound/PointSpread.h).
struct PictureField {
  double width_mm = 0;      ///< of the rectangle
  double fanAngle_deg = 0;  ///< full angle; 0: a rectangle
  double faceRadius_mm = 0;
  double sliceHalf_mm = 0;  ///< half the slice thickness (FWHM) where it is narrowest; 0: this attempt has no image
  double elevationFocus_mm = 0;          ///< depth of the narrowest place, below the face
  double elevationDivergence = 0;        ///< growth of the thickness per mm before that depth; 0: not known, none
  double elevationDivergenceBehind = 0;  ///< growth of the thickness per mm behind that depth

  bool operator==(const PictureField&) const = default;
};

/// Distance from the plane at which the image still shows a needle at this range from the face: one slice thickness,
/// hypot(minimum thickness, divergence * distance from the narrowest place). An echo there has lost about 20 log10(16)
/// = 24 dB, by a Gaussian beam: as much as a needle at 45 degrees exceeds speckle (ultrasound/README.md, "Needle").
double shownOffPlane_mm(const PictureField& field, double range_mm);

/// Tells whether a live image of this depth shows a needle's tip at a point of the probe's frame.
bool shows(const PictureField& field, double depth_mm, Vec3 tip_probe);

}  // namespace insonate
