#pragma once

#include <insonate/core/Vec3.h>

namespace insonate {

/// Where the live image shows something, in the probe's frame. In its plane, y = 0, it is a rectangle, or a fan about
/// an apex `faceRadius_mm` behind the face. Across the plane it is as thick as the beam
/// (Probe::elevationFwhm_wavelengths).
struct PictureField {
  double width_mm = 0;      ///< of the rectangle
  double fanAngle_deg = 0;  ///< full angle; 0: a rectangle
  double faceRadius_mm = 0;
  double sliceHalf_mm = 0;  ///< half the slice thickness (FWHM) at the elevation focus; 0: this attempt has no image
  double elevationFocus_mm = 0;    ///< below the face
  double elevationDivergence = 0;  ///< growth of the slice thickness per mm off that focus; 0: not known, none

  bool operator==(const PictureField&) const = default;
};

/// How far off the plane the image still shows a needle at this distance from the face: one slice thickness,
/// hypot(thickness at the focus, divergence * distance from the focus). The beam is a Gaussian, so that an echo there
/// has lost 20 log10(16) = 24 dB: as much as a needle at 45 degrees stands out from speckle (ultrasound/README.md,
/// "Needle").
double shownOffPlane_mm(const PictureField& field, double range_mm);

/// Whether a live image of this depth shows a needle's tip at a point of the probe's frame.
bool shows(const PictureField& field, double depth_mm, Vec3 tip_probe);

}  // namespace insonate
