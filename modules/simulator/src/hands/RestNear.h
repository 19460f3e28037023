#pragma once

#include <insonate/core/Transform.h>
#include <insonate/image/PlaneDisplacement.h>

#include <vector>

namespace insonate {

/// Distance from the probe's plane up to which tissue moves with the plane, since the housing rests on it; the motion
/// fades to zero at twice this distance.
inline constexpr double kMovesBeside_mm = 8;

/// Affine map from patient space to the place of the tissue at rest, valid near a point. It is fitted to the plane's
/// displacement there, over about 3 mm. The identity where nothing moved, far from the plane, and where the
/// displacement varies too quickly for an affine map.
Transform restNear(const PlaneDisplacement& displacement, const Transform& patientFromProbe, Vec3 patient_mm);

/// Computes LivePress::middleAtRest_mm of an image of this depth. Allocates nothing if `points_mm` already has its
/// size.
void restAlongMiddle(const PlaneDisplacement& displacement, const Transform& patientFromProbe, double depth_mm,
                     std::vector<Vec3>& points_mm);

}  // namespace insonate
