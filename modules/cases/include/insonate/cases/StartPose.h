#pragma once

#include <insonate/cases/PatientCase.h>

namespace insonate {

/// Proposes where to put the probe for a transverse look: on the skin nearest to the first target as seen from the
/// front (within 60 degrees of straight anterior, in the transverse plane), looking at the target; without a target, on
/// the front of the patient at the middle of the volume, looking straight back. `lateral` points to the patient's left
/// (+x in LPS), which is the right side of a transverse picture by convention. The body is every labelled voxel, or,
/// where the label map is empty, everything denser than -300 HU. Fails when no skin is met.
Result<StartPose> proposeStartPose(const PatientCase& patient);

/// The pose that `auto` means: the case's first start pose, else the proposed one.
Result<StartPose> autoStartPose(const PatientCase& patient);

}  // namespace insonate
