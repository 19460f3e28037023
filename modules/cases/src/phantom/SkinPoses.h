#pragma once

#include "RegionModel.h"

namespace insonate::phantom {

/// Returns the distance along a ray from inside the body to the skin.
double toSkin_mm(const RegionModel& region, Vec3 from_mm, Vec3 direction);

/// Returns the normal of the skin under a face, from differences over `step_mm` to either side.
Vec3 inwardNormal(const RegionModel& region, Vec3 at_mm, double step_mm);

/// Returns the unit direction that is nearest to `direction` and perpendicular to `axial`.
Vec3 orthogonalTo(Vec3 axial, Vec3 direction);

/// A place of the probe: the point of the skin under the middle of the face, and the direction into the body.
struct SkinPlace {
  Vec3 skin_mm, axial;
};

/// Returns the place on the skin from which a probe that is perpendicular to the skin points at `inside_mm`.
SkinPlace placeOver(const RegionModel& region, Vec3 inside_mm, double step_mm);

}  // namespace insonate::phantom
