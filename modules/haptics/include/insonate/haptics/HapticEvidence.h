#pragma once

#include <insonate/haptics/SimulatedHand.h>
#include <insonate/haptics/TissueGrid.h>
#include <insonate/tissue/NeedleTable.h>

#include <memory>
#include <vector>

/// Measurements of the servo, for tests and benchmarks.
namespace insonate {

/// Makes layers perpendicular to z, which points into the body from the skin at 0: skin, fat from 2 mm, muscle from 10
/// mm, a vein from 18 to 28 mm, muscle, bone from 40 mm.
std::shared_ptr<const TissueGrid> benchLayers();

struct ForceDepthPoint {
  double depth_mm = 0;  ///< depth of the tip below the skin at rest
  double force_N = 0;   ///< resistance along the needle
  Label in = kBackground;
};

/// Computes the force on a needle that is driven perpendicularly through benchLayers() and back at constant speed, by a
/// machine that does not yield. `steepest_Npmm`: maximum stiffness that the device can render.
std::vector<ForceDepthPoint> forceDepth(const NeedleTable& table, double speed_mmps, double steepest_Npmm,
                                        double deepest_mm);

/// Returns the maximum stiffness of a wall, N/mm, at which a device held by a hand is stable, searched in steps of 7 %
/// up to 20 N/mm. The device is hit with 50 mm/s. It is stable if it moves more slowly in the last of two seconds than
/// in the first, or by less than a quarter of its encoder's step per tick. `account`: the servo's energy account is
/// used.
double greatestStableStiffness_Npmm(const DeviceLimits& device, const Grip& grip, bool account);

}  // namespace insonate
