#pragma once

#include "model/FramePlan.h"
#include "scene/SceneData.h"

#include <insonate/image/PlaneDisplacement.h>

namespace insonate {

/// Contact of a scanline with the skin.
struct Contact {
  double gap_mm = 0;    ///< skin beyond the face (above 0) or the face inside the skin (below 0)
  double strength = 1;  ///< 0: no contact, nothing is heard; 1: full
};

/// Looks for the skin of the displaced tissue along a scanline, `origin` and `direction` in the probe frame. A face
/// deep inside the body, or a volume without outside, is in full contact.
Contact contactOf(const TissueField& field, const Transform& patientFromProbe, const PlaneDisplacement& displacement,
                  Vec3 origin_mm, Vec3 direction);

/// Range in tissue that the face has not drawn to it, of a range from the face: skin follows the face, deep tissue
/// stays. Where a displacement has brought the skin to the face, there is no gap and nothing left to draw.
double tissueRange_mm(double range_mm, double gap_mm);

}  // namespace insonate
