#pragma once

#include <insonate/core/Transform.h>
#include <insonate/image/VolumeGeometry.h>
#include <insonate/views/Input.h>

#include <string>

namespace insonate::views {

/// Orientation of a slice. Axial slices are seen from the feet and coronal ones from the front, so that the patient's
/// right is on the left; sagittal ones have the front on the left. Oblique is the probe's imaging plane, the skin on
/// top and the marker's side on the right, as in the ultrasound image.
enum class SliceKind { Axial, Coronal, Sagittal, Oblique };

/// Patient directions (unit, LPS) of a slice on the display.
struct SliceAxes {
  Vec3 right{1, 0, 0}, up{0, -1, 0};
  /// Slices are counted along it: to the patient's left, back or head; along the probe's elevation.
  Vec3 normal{0, 0, 1};
};

/// `patientFromProbe` matters for oblique slices only.
SliceAxes sliceAxes(SliceKind kind, const Transform& patientFromProbe = {});

/// A slice on a display of square pixels: where in the patient each pixel lies.
struct SlicePlane {
  SliceAxes axes;
  Vec3 centre_mm;          ///< patient LPS, at the middle of the display
  double mm_per_px = 0.5;  ///< above 0
  int width_px = 1, height_px = 1;

  Vec3 patientFromDisplay(DisplayPoint at) const;
  /// Projects a point onto the slice.
  DisplayPoint displayFromPatient(Vec3 point_mm) const;
  /// Signed distance of a point from the slice, along the normal.
  double distance_mm(Vec3 point_mm) const { return dot(point_mm - centre_mm, axes.normal); }
};

/// Letters for a patient direction: L or R, P or A, S or I, the strongest first, weaker ones only when they matter
/// ("A", "RA", "SPL").
std::string orientationLetters(Vec3 direction);

/// Distance between slices that a grid has along a direction.
double sliceStep_mm(const VolumeGeometry& grid, Vec3 normal);

}  // namespace insonate::views
