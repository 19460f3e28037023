#pragma once

#include <insonate/cases/CaseView.h>

namespace insonate {

/// Proposes a start pose for a transverse image. With a target, the probe is placed over the first target and points to
/// it: on the nearest skin within 60 degrees of straight anterior, in the transverse plane. Without a target, the probe
/// is placed on the front of the neck, perpendicular to the skin, 25 mm to the patient's right of the midline. The neck
/// is the level that is clearly narrower than the levels above and below it; without such a level, the middle of the
/// volume is used. In both cases the nearest place is taken where at least 90 % of the face of a 38 mm linear probe
/// meets skin that gives way by 5 mm; if there is none, the place with the most contact. `lateral` points to the
/// patient's left (+x in LPS), which is by convention the right side of a transverse image. The body is every labeled
/// voxel, or, if the label map is empty, every voxel above -300 HU. Fails if no skin is found.
Result<StartPose> proposeStartPose(const CaseView& patient);

/// Proposes a start pose for a transverse image over this target.
Result<StartPose> poseOver(const CaseView& patient, const Target& target);

/// Returns the pose for the value `auto` of the command line: the case's first start pose, else the proposed one.
Result<StartPose> autoStartPose(const CaseView& patient);

}  // namespace insonate
