#pragma once

#include "NeckFit.h"

#include <insonate/segmentation/VesselTracking.h>

namespace insonate::segmentation {

/// Signs by which the confidence in a vessel is estimated.
struct VesselSigns {
  double evidence = 0;   ///< mean over the vessel, 0 to 1 (FoundStation)
  double weakest = 0;    ///< lowest mean over 10 mm of the vessel
  double offCourse = 0;  ///< mean distance to the expected course, relative to its spread
  double offPath = 0;    ///< mean distance between the tracked and the searched line, relative to the expected radius
  double widening = 1;   ///< radius of the tracked vessel, relative to the expected radius
};

struct NeckVessel {
  TrackedVessel tracked;
  VesselSigns signs;
  std::vector<TakenStation> taken;  ///< place and radius at each level
  Vec3 weakest_mm;                  ///< place with the weakest evidence
};

/// Finds a vessel near its expected course. `taken` are the vessels in the way. Empty if the CT does not show enough of
/// the vessel, or if it cannot be tracked.
std::optional<NeckVessel> foundVessel(const CtVolume& ct, const std::vector<VesselStation>& expected, bool isArtery,
                                      const std::vector<TakenStation>& taken, Work& work);

/// Returns the estimated probability that a vessel with these signs is right.
double confidenceOf(const VesselSigns& signs);

}  // namespace insonate::segmentation
