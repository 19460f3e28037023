#pragma once

#include "NeckModel.h"

#include <insonate/cases/PatientCase.h>

namespace insonate::phantom {

/// Returns targets in both internal jugular veins at the level of the cricoid, right first.
std::vector<Target> jugularTargets(const NeckModel& neck);

/// Returns transverse and longitudinal probe poses for each target: on the skin near the vein, a little anterior,
/// pointing along the skin's inward normal.
std::vector<StartPose> jugularStartPoses(const NeckModel& neck);

/// Returns the target below the middle of the right clavicle, or, if `axillary` is true, in the axillary vein lateral
/// of the first rib.
std::vector<Target> chestTargets(const NeckModel& chest, bool axillary);

/// Returns two probe poses over this target: transverse with the marker toward the head, longitudinal with the marker
/// toward the heart.
std::vector<StartPose> chestStartPoses(const NeckModel& chest, bool axillary);

/// Returns cricoid, sternal notch, both clavicles, and a puncture site for each transverse pose.
std::vector<Landmark> landmarks(const NeckModel& neck, const std::vector<StartPose>& poses);

}  // namespace insonate::phantom
