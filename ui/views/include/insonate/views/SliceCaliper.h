#pragma once

#include <insonate/views/Caliper.h>
#include <insonate/views/SlicePlane.h>

#include <array>

namespace insonate::views {

/// A caliper on a CT slice; its points are in patient space (LPS, mm) and lie in one plane.
struct SliceCaliper {
  CaliperKind kind = CaliperKind::Distance;
  std::array<Vec3, 3> points_mm;  ///< a distance uses only points 0 and 1
};

/// Converts a caliper to the plane of the slice, for measure(): lateral is to the right on the display, axial downward.
Caliper onSlice(const SliceCaliper& caliper, const SliceAxes& axes);
ImagePoint onSlice(Vec3 patient_mm, const SliceAxes& axes);
/// Converts a point of the slice through `through_mm` to patient space.
Vec3 fromSlice(ImagePoint at, const SliceAxes& axes, Vec3 through_mm);

}  // namespace insonate::views
