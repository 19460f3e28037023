#pragma once

#include "NeckModel.h"

#include <insonate/cases/PatientCase.h>

namespace insonate::phantom {

/// Both internal jugular veins at the level of the cricoid, right first.
std::vector<Target> jugularTargets(const NeckModel& neck);

/// Transverse and longitudinal probe poses over each target: on the skin near the vein, a little to the
/// front, looking along the inward normal.
std::vector<StartPose> jugularStartPoses(const NeckModel& neck);

/// Targets in the right subclavian vein below the middle of the clavicle, where it is called axillary.
std::vector<Target> axillaryTargets(const NeckModel& neck);

/// Across the vein, the marker toward the head, and along it, the marker toward the heart.
std::vector<StartPose> axillaryStartPoses(const NeckModel& neck);

/// Cricoid, sternal notch, both clavicles, and a puncture site for each pose that looks across a vein.
std::vector<Landmark> landmarks(const NeckModel& neck, const std::vector<StartPose>& poses);

}  // namespace insonate::phantom
