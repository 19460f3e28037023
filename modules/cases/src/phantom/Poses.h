#pragma once

#include "NeckModel.h"

#include <insonate/cases/PatientCase.h>

namespace insonate::phantom {

/// Both internal jugular veins at the level of the cricoid, right first.
std::vector<Target> jugularTargets(const NeckModel& neck);

/// Transverse and longitudinal probe poses over each target: on the skin near the vein, a little to the
/// front, looking along the inward normal.
std::vector<StartPose> jugularStartPoses(const NeckModel& neck);

}  // namespace insonate::phantom
