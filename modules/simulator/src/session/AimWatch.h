#pragma once

#include <insonate/haptics/TissueGrid.h>
#include <insonate/simulator/LiveAttempt.h>
#include <insonate/simulator/VesselLocator.h>
#include <insonate/ultrasound/Needle.h>

#include <span>

namespace insonate {

/// Finds what the needle would meet first if it were advanced along its axis by its whole length. The computation uses
/// undeformed tissue; compression moves a vein by a few millimeters at most. A needle whose tip is in the body and that
/// passes within kAimTolerance_mm of a vein therefore counts as aimed at the vein. If another vein is in front of the
/// target, the result is Beside. Beyond the grid nothing is met. Neither waits nor allocates.
NeedleAim aimOf(const Needle& needle, const TissueGrid& grid, const VesselLocator& vessels,
                std::span<const CenterLine> veins) noexcept;

inline constexpr double kAimTolerance_mm = 1.5;

}  // namespace insonate
