#pragma once

#include <insonate/haptics/TissueGrid.h>
#include <insonate/simulator/LiveAttempt.h>
#include <insonate/simulator/VesselLocator.h>
#include <insonate/ultrasound/Needle.h>

#include <span>

namespace insonate {

/// Finds the vessel that the needle of a live image would puncture first if it were advanced along its axis by its
/// whole length. The vessels are where the probe's compression has displaced them in this image, as for the force loop.
/// A vein that the needle meets flatter than kRollCosine is only grazed or pushed aside, and does not count. If another
/// vein is in front of the target, the result is Beside. Beyond the grid nothing is met. The result is Unknown without
/// a needle. `tent_mm`: NeedleState::tent_mm; the tissue up to this distance behind the tip lies before the wall that
/// the tip indents. Neither waits nor allocates.
NeedleAim aimOf(const LiveFrame& frame, double tent_mm, const TissueGrid& grid, const VesselLocator& vessels,
                std::span<const CenterLine> veins) noexcept;

}  // namespace insonate
