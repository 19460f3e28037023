#pragma once

#include <insonate/core/Transform.h>
#include <insonate/image/PlaneDisplacement.h>

#include <vector>

namespace insonate {

/// Distance beside the probe's plane up to which tissue moves with it: the housing lies on it there; the motion fades
/// to zero at twice that.
inline constexpr double kMovesBeside_mm = 8;

/// restFromPatient near a point: where its tissue lay at rest, as the straight map that is nearest to the plane's
/// displacement there, over about 3 mm. The identity where nothing moved, far beside the plane, and where the
/// displacement turns so quickly that no straight map is near it.
Transform restNear(const PlaneDisplacement& displacement, const Transform& patientFromProbe, Vec3 patient_mm);

/// LivePress::middleAtRest_mm of an image of this depth. Allocates nothing once `points_mm` has its size.
void restAlongMiddle(const PlaneDisplacement& displacement, const Transform& patientFromProbe, double depth_mm,
                     std::vector<Vec3>& points_mm);

}  // namespace insonate
