#pragma once

#include <insonate/cases/CaseView.h>

namespace insonate {

/// Proposes where to put the probe for a transverse look: on the skin nearest to the first target as seen from the
/// front (within 60 degrees of straight anterior, in the transverse plane), looking at the target; without a target, on
/// the front of the neck (the level that is clearly narrower than those above and below it; where there is none, the
/// middle of the volume), 25 mm to the patient's right of the midline, square to the skin. `lateral` points to the
/// patient's left
/// (+x in LPS), which is the right side of a transverse image by convention. The body is every labeled voxel, or,
/// where the label map is empty, everything denser than -300 HU. Fails when no skin is met.
Result<StartPose> proposeStartPose(const CaseView& patient);

/// Proposes a start pose over any target.
Result<StartPose> poseOver(const CaseView& patient, const Target& target);

/// The pose that `auto` means: the case's first start pose, else the proposed one.
Result<StartPose> autoStartPose(const CaseView& patient);

}  // namespace insonate
