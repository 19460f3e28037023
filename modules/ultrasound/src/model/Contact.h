#pragma once

#include "model/FramePlan.h"
#include "scene/SceneData.h"

namespace insonate {

/// How a scanline meets the skin.
struct Contact {
  double gap_mm = 0;    ///< skin beyond the face (above 0) or the face inside the skin (below 0)
  double strength = 1;  ///< 0: no contact, nothing is heard; 1: full
};

/// Looks for the skin along a scanline, `origin` and `direction` in patient LPS. A face deep inside the body, or a
/// volume without outside, is in full contact.
Contact contactOf(const TissueField& field, Vec3 origin_mm, Vec3 direction);

/// Range in undeformed tissue of a range from the face: skin follows the face, deep tissue stays.
double tissueRange_mm(double range_mm, double gap_mm);

}  // namespace insonate
