#pragma once

#include <insonate/views/Calliper.h>
#include <insonate/views/SlicePlane.h>

#include <array>

namespace insonate::views {

/// A measurement on a slice of the CT; its points are patient LPS mm and lie in one plane.
struct SliceCalliper {
  CalliperKind kind = CalliperKind::Distance;
  std::array<Vec3, 3> points_mm;  ///< a distance uses two
};

/// Converts a caliper to the plane's own millimeters for measuring: lateral to the right of the display, axial down.
Calliper onSlice(const SliceCalliper& calliper, const SliceAxes& axes);
PicturePoint onSlice(Vec3 patient_mm, const SliceAxes& axes);
/// The patient point of a place on the slice that passes through `through_mm`.
Vec3 fromSlice(PicturePoint at, const SliceAxes& axes, Vec3 through_mm);

}  // namespace insonate::views
