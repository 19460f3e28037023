#pragma once

#include <insonate/simulator/ProbePlacement.h>
#include <insonate/simulator/VesselLocator.h>

#include <cstdint>
#include <span>

namespace insonate {

/// Number of start positions of the probe, from which one is chosen at random for each attempt. Their distances from
/// the vein differ, so that no memorized sequence of moves centers the vein.
inline constexpr int kAttemptStarts = 4;

/// Returns a start pose of the probe for an attempt, beside the target vein. `place` (0 to kAttemptStarts - 1) selects
/// the distance along the skin from the vein: about 14 or 29 mm to either side, or less where the skin ends. `seed`
/// determines a random shift along the vein of up to 8 mm and a random rotation of up to 6 degrees. `home` is a start
/// pose of the case, whose indentation and angles are kept. In a case without a known vein the distances are measured
/// from `home`.
ProbePlacementState attemptStart(const ProbePlacement& home, const VesselLocator& vessels,
                                 std::span<const CenterLine> veins, int place, std::uint32_t seed);

}  // namespace insonate
