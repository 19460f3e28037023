#pragma once

#include <insonate/core/Vec3.h>

namespace insonate {

/// Region that the live image shows, in the probe frame. In the image plane (y = 0) the region is a rectangle, or a fan
/// with its apex `faceRadius_mm` behind the face. Perpendicular to the image plane the region is as thick as the beam,
/// according to SliceLaw (insonate/ultrasound/PointSpread.h).
struct ImageField {
  double width_mm = 0;      ///< width of a rectangular region
  double fanAngle_deg = 0;  ///< full angle of a fan; 0: the region is a rectangle
  double faceRadius_mm = 0;
  double sliceHalf_mm = 0;       ///< half the minimum slice thickness of the beam (FWHM); 0: there is no image
  double elevationFocus_mm = 0;  ///< depth below the probe's face at which the slice is thinnest
  /// growth of the slice thickness per mm of distance from elevationFocus_mm, toward the probe; 0: unknown or none
  double elevationDivergence = 0;
  /// growth of the slice thickness per mm of distance from elevationFocus_mm, away from the probe
  double elevationDivergenceBehind = 0;

  bool operator==(const ImageField&) const = default;
};

/// Returns how far from the image plane a needle at the range `range_mm` from the probe's face may be so that the image
/// still shows it: one slice thickness. At a range r, the slice thickness is hypot(t, g (r - f)), with its minimum t at
/// the range f (ImageField::elevationFocus_mm) and its growth g (ImageField::elevationDivergence). At this offset, a
/// Gaussian beam reduces an echo by about 24 dB (20 log10(16)), and a needle at 45 degrees is about 24 dB brighter than
/// speckle (ultrasound/README.md, "Needle").
double maxOffPlane_mm(const ImageField& field, double range_mm);

/// Tells whether a live image of depth `depth_mm` shows a needle's tip at a point in the probe frame.
bool isTipInView(const ImageField& field, double depth_mm, Vec3 tip_probe);

}  // namespace insonate
