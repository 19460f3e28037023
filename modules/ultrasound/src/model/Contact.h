#pragma once

#include "model/FramePlan.h"
#include "scene/SceneData.h"

#include <insonate/image/PlaneDisplacement.h>

namespace insonate {

/// Contact between the skin and the probe's face at a scanline.
struct Contact {
  double gap_mm = 0;    ///< above 0: width of the gap between face and skin; below 0: depth of the face inside the skin
  double strength = 1;  ///< 0: no contact, no echo is received; 1: full contact
};

/// Finds the contact at a scanline by searching for the skin of the displaced tissue along the scanline; `origin_mm`
/// and `direction` are in the probe frame. A face deep inside the body, or a volume without outside, has full contact.
Contact contactOf(const TissueField& field, const Transform& patientFromProbe, const PlaneDisplacement& displacement,
                  Vec3 origin_mm, Vec3 direction);

/// Converts a range from the face to a range in undeformed tissue: the skin across a gap is drawn to the face, while
/// deep tissue stays. If a displacement has already brought the skin to the face, there is no gap, and the range is
/// unchanged.
double tissueRange_mm(double range_mm, double gap_mm);
/// Returns the range from the face at which tissue of a range in undeformed tissue is displayed; the inverse of
/// tissueRange_mm().
double displayedRange_mm(double tissueRange_mm, double gap_mm);

}  // namespace insonate
