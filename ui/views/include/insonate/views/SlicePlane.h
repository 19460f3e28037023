#pragma once

#include <insonate/core/Transform.h>
#include <insonate/image/VolumeGeometry.h>
#include <insonate/views/Input.h>

#include <string>

namespace insonate::views {

/// Orientation of a slice. Axial slices are seen from the feet and coronal slices from the front, so that the patient's
/// right is on the left; sagittal slices show the front on the left. Oblique is the image plane of the probe, with the
/// skin on top and the marker's side on the right, as in the ultrasound image.
enum class SliceKind { Axial, Coronal, Sagittal, Oblique };

/// Directions of a slice's display in patient space (unit vectors, LPS).
struct SliceAxes {
  Vec3 right{1, 0, 0}, up{0, -1, 0};
  /// Slices are numbered along this direction: to the patient's left, back or head, or along the probe's elevation.
  Vec3 normal{0, 0, 1};
};

/// Returns the directions for a kind of slice; `patientFromProbe` is used for oblique slices only.
SliceAxes sliceAxes(SliceKind kind, const Transform& patientFromProbe = {});

/// A slice on a display with square pixels, which converts between pixels and points in patient space.
struct SlicePlane {
  SliceAxes axes;
  Vec3 center_mm;          ///< patient space (LPS), at the center of the display
  double mm_per_px = 0.5;  ///< size of a pixel; above 0
  int width_px = 1, height_px = 1;

  Vec3 patientFromDisplay(DisplayPoint at) const;
  /// Projects a point onto the slice and converts it to the display.
  DisplayPoint displayFromPatient(Vec3 point_mm) const;
  /// Returns the signed distance of a point from the slice, along the normal.
  double distance_mm(Vec3 point_mm) const { return dot(point_mm - center_mm, axes.normal); }
};

/// Returns the orientation letters of a direction (LPS): L or R, P or A, H (head) or F (foot), as in DICOM, with the
/// largest component first and small components left out, e.g. "A", "RA", "HPL".
std::string orientationLetters(Vec3 direction);
/// Returns the side of the patient toward which a direction (LPS) mainly points, at most 55 degrees away: "R", "L",
/// "A", "P", "Head" or "Foot".
std::string patientSide(Vec3 direction);

/// Returns the distance between slices of a grid along a direction.
double sliceStep_mm(const VolumeGeometry& grid, Vec3 normal);

}  // namespace insonate::views
