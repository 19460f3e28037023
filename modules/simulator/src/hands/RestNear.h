#pragma once

#include <insonate/core/Transform.h>
#include <insonate/image/PlaneDisplacement.h>

#include <vector>

namespace insonate {

/// Distance from the image plane up to which tissue is displaced like the tissue in the plane, since the probe's
/// housing rests on this tissue; the displacement decreases to zero at twice this distance.
inline constexpr double kMovesBeside_mm = 8;

/// Returns an affine map from patient space to the undeformed position of the tissue, valid near `patient_mm`. The map
/// is fitted to the displacement in the image plane over about 3 mm. It is the identity where nothing moved, far from
/// the plane and from the face, and where the displacement varies too quickly for an affine map.
Transform restNear(const PlaneDisplacement& displacement, const Transform& patientFromProbe, Vec3 patient_mm);

/// Returns the vector from a point (probe frame) to the undeformed position of its tissue, probe frame. The
/// displacement in the image plane decreases to zero beside the plane and beside the lattice.
Vec3 shiftNear(const PlaneDisplacement& displacement, Vec3 probe_mm);

/// Computes LiveDeformation::displacement: every n-th point of the lattice, so that the points are 1 mm or more apart.
/// Allocates nothing if `thin` already has its size.
void thinOut(const PlaneDisplacement& displacement, PlaneDisplacement& thin);

/// Computes LiveDeformation::middleAtRest_mm (undeformed positions along the image's middle line) for an image depth.
/// Allocates nothing if `points_mm` already has its size.
void restAlongMiddle(const PlaneDisplacement& displacement, const Transform& patientFromProbe, double depth_mm,
                     std::vector<Vec3>& points_mm);

}  // namespace insonate
