#pragma once

#include <insonate/haptics/SimulatedHand.h>
#include <insonate/haptics/TissueGrid.h>
#include <insonate/tissue/NeedleTable.h>

#include <memory>
#include <vector>

/// Measurements of the servo, for tests and benchmarks.
namespace insonate {

/// Layers perpendicular to z, which points into the body from the skin at 0: skin, fat from 2 mm, muscle from 10, a
/// vein from 18 to 28, muscle, bone from 40.
std::shared_ptr<const TissueGrid> benchLayers();

struct ForceDepthPoint {
  double depth_mm = 0;  ///< of the tip below the skin at rest
  double force_N = 0;   ///< resistance along the needle
  Label in = kBackground;
};

/// A needle driven square through benchLayers() and back again at a speed, by a machine that does not give way.
/// `steepest_Npmm`: of the device that would show it.
std::vector<ForceDepthPoint> forceDepth(const NeedleTable& table, double speed_mmps, double steepest_Npmm,
                                        double deepest_mm);

/// The greatest stiffness of a wall, N/mm, on which a device in a hand does not swing more and more, by search in steps
/// of 7 % up to 20: knocked with 50 mm/s, it moves more slowly in the last of two seconds than in the first, or by
/// less than a quarter of its encoder's step in a tick. `account`: with the servo's account of energy.
double greatestStableStiffness_Npmm(const DeviceLimits& device, const Grip& grip, bool account);

}  // namespace insonate
