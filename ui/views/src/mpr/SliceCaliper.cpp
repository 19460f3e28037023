#include <insonate/views/SliceCaliper.h>

namespace insonate::views {

ImagePoint onSlice(Vec3 patient_mm, const SliceAxes& axes) {
  return {dot(patient_mm, axes.right), -dot(patient_mm, axes.up)};
}

Caliper onSlice(const SliceCaliper& caliper, const SliceAxes& axes) {
  Caliper flat{caliper.kind, {}};
  for (std::size_t k = 0; k < flat.points.size(); ++k) flat.points[k] = onSlice(caliper.points_mm[k], axes);
  return flat;
}

Vec3 fromSlice(ImagePoint at, const SliceAxes& axes, Vec3 through_mm) {
  return axes.right * at.lateral_mm - axes.up * at.axial_mm + axes.normal * dot(through_mm, axes.normal);
}

}  // namespace insonate::views
