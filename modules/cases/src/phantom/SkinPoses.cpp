#include "SkinPoses.h"

namespace insonate::phantom {

double toSkin_mm(const RegionModel& region, Vec3 from_mm, Vec3 direction) {
  double inside = 0, outside = 80;
  for (int n = 0; n < 40; ++n) {
    const double middle = 0.5 * (inside + outside);
    (region.belowSkin_mm(from_mm + direction * middle) > 0 ? inside : outside) = middle;
  }
  return inside;
}

Vec3 inwardNormal(const RegionModel& region, Vec3 at_mm, double step_mm) {
  Vec3 gradient;
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 step;
    step[axis] = step_mm;
    gradient[axis] = region.belowSkin_mm(at_mm + step) - region.belowSkin_mm(at_mm - step);
  }
  return normalized(gradient);
}

Vec3 orthogonalTo(Vec3 axial, Vec3 direction) {
  return normalized(direction - axial * dot(axial, direction));
}

SkinPlace placeOver(const RegionModel& region, Vec3 inside_mm, double step_mm) {
  Vec3 axial{0, 1, 0}, skin;
  for (int n = 0; n < 8; ++n) {
    skin = inside_mm - axial * toSkin_mm(region, inside_mm, -axial);
    if (n < 7) axial = inwardNormal(region, skin, step_mm);
  }
  return {skin, axial};
}

}  // namespace insonate::phantom
