#pragma once

#include <insonate/simulator/ProbeHand.h>
#include <insonate/simulator/VesselNames.h>

#include <cstdint>
#include <span>

namespace insonate {

/// Number of probe positions from which one is drawn for the beginning of an attempt. The distance to the vein differs
/// between them, so that a memorized sequence of moves does not center the vein.
inline constexpr int kAttemptStarts = 4;

/// Returns the pose of a probe beside the target vein, at which an attempt begins: about 14 or 29 mm to either side of
/// the vein over the skin (`place`, 0 to kAttemptStarts - 1), or less where the skin ends; moved along the vein by up
/// to 8 mm and turned by up to 6 degrees (`seed`). `home` is a start pose of the case; its indentation and angles are
/// kept. In a case without a known vein the same distances are measured from `home`.
ProbeHandState attemptStart(const ProbeHand& home, const VesselNames& vessels, std::span<const CentreLine> veins,
                            int place, std::uint32_t seed);

}  // namespace insonate
