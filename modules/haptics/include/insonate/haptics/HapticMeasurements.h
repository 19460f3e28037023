#pragma once

#include <insonate/haptics/SimulatedHand.h>
#include <insonate/haptics/TissueGrid.h>
#include <insonate/tissue/NeedleTable.h>

#include <memory>
#include <vector>

/// These functions measure the force loop (HapticServo), for tests and benchmarks.
namespace insonate {

/// Makes a tissue phantom of plane layers. z points into the body. Depths of the layers: skin from 0, fat from 2 mm,
/// muscle from 10 mm, a vein from 18 to 28 mm, muscle from 28 mm, bone from 40 mm.
std::shared_ptr<const TissueGrid> layeredPhantom();

/// One point of a force-depth curve of needle insertion.
struct ForceDepthPoint {
  double depth_mm = 0;  ///< depth of the needle's tip below the undeformed skin
  double force_N = 0;   ///< axial resistance of the tissue to the needle
  Label in = kBackground;
};

/// Computes the force on a needle that a rigid testing machine drives into layeredPhantom() at constant speed,
/// perpendicular to the layers, to the depth `deepest_mm` and back. `steepest_Npmm`: maximum stiffness that the haptic
/// device can render.
std::vector<ForceDepthPoint> needleForceCurve(const NeedleTable& table, double speed_mmps, double steepest_Npmm,
                                              double deepest_mm);

/// Returns the maximum stiffness of a virtual wall at which a hand-held device is stable, found by a search in steps of
/// 7 % up to 20 N/mm. The device hits the wall at 50 mm/s. The device is stable if it moves more slowly in the second
/// second than in the first, or by less than a quarter of an encoder step per tick. `account`, true: measured with
/// passivity control, which limits the energy that the force loop returns to the hand; false: without.
double maxStableStiffness_Npmm(const DeviceLimits& device, const Grip& grip, bool account);

}  // namespace insonate
