#pragma once

#include <insonate/cases/CaseView.h>

namespace insonate {

/// Proposes a start pose for a transverse image. With a target, the probe is placed on the skin over the first target
/// and points to it. The place is the nearest skin in the transverse plane, in a direction within 60 degrees of
/// anterior. Without a target, the probe is placed on the front of the neck, perpendicular to the skin, 25 mm to the
/// patient's right of the midline. The level of the neck is the one that is clearly narrower than the levels above and
/// below it; without such a level, the middle of the volume is used. In both cases, the probe is moved to the nearest
/// place where at least 90 % of the face of a 38 mm linear probe touches skin that yields by 5 mm; without such a
/// place, to the place with the largest contact. `lateral` points to the patient's left (+x in LPS), which is by
/// convention the right side of a transverse image. The body consists of all labeled voxels or, if the label map is
/// empty, of all voxels above -300 HU. Fails if no skin is found.
Result<StartPose> proposeStartPose(const CaseView& patient);

/// Proposes a start pose for a transverse image over this target.
Result<StartPose> proposeStartPoseOver(const CaseView& patient, const Target& target);

/// Returns the case's first start pose; if the case has none, the proposed start pose. The command line uses this
/// function for the value `auto`.
Result<StartPose> autoStartPose(const CaseView& patient);

}  // namespace insonate
