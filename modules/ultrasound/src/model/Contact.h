#pragma once

#include "model/FramePlan.h"
#include "scene/SceneData.h"

#include <insonate/image/PlaneDisplacement.h>

namespace insonate {

/// Contact of a scanline with the skin.
struct Contact {
  double gap_mm = 0;    ///< above 0: gap between face and skin; below 0: depth of the face inside the skin
  double strength = 1;  ///< 0: no contact, no echo is received; 1: full contact
};

/// Finds the skin of the displaced tissue along a scanline; `origin` and `direction` are in the probe frame. A face
/// deep inside the body, or a volume without outside, has full contact.
Contact contactOf(const TissueField& field, const Transform& patientFromProbe, const PlaneDisplacement& displacement,
                  Vec3 origin_mm, Vec3 direction);

/// Converts a range from the face to a range in tissue that the face has not attracted: the skin follows the face, deep
/// tissue stays. If a displacement has brought the skin to the face, there is no gap, and the range stays the same.
double tissueRange_mm(double range_mm, double gap_mm);

}  // namespace insonate
