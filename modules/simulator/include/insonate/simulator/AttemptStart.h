#pragma once

#include <insonate/simulator/ProbeHand.h>
#include <insonate/simulator/VesselNames.h>

#include <cstdint>
#include <span>

namespace insonate {

/// Number of places where an attempt of a level may begin. Between any two, the probe has to be slid over the vein by
/// another distance, so that no fixed list of moves centers the vein from both.
inline constexpr int kAttemptStarts = 4;

/// A probe beside the target vein, where a level's attempt begins: about 14 or 29 mm to either side of it over the
/// skin (`place`, 0 to kAttemptStarts - 1), as far as the skin goes, moved along the vein by up to 8 mm and turned by
/// up to 6 degrees (`seed`). `home` is a start pose of the case, whose press and angles are kept. A case that knows
/// no vein gives the same distances from `home`.
ProbeHandState attemptStart(const ProbeHand& home, const VesselNames& vessels, std::span<const CentreLine> veins,
                            int place, std::uint32_t seed);

}  // namespace insonate
