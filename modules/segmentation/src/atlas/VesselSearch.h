#pragma once

#include "Work.h"

#include <insonate/image/Volume.h>

#include <vector>

namespace insonate::segmentation {

/// Expected place of a vessel at one level of the neck, patient space.
struct VesselStation {
  Vec3 center_mm;
  double spread_mm = 1;  ///< standard deviation of the expected place across the level
  double radius_mm = 3;  ///< expected radius
};

/// The vessel that was found at one level.
struct FoundStation {
  Vec3 center_mm;
  double evidence = 0;  ///< how much the CT there looks like a vessel: 0 not at all, 1 a bright or dark-rimmed disk
};

/// A place in which no other vessel may be: a vessel that was found before.
struct TakenStation {
  Vec3 center_mm;
  double radius_mm = 0;
};

/// Finds a vessel near its expected course: the smooth course that passes through places which look like a section of
/// a vessel, and that stays close to the expected course. A section of a vessel is even, and has a dark rim (fat or
/// the vessel's sheath) in all directions; with contrast agent it is brighter than everything around. `isFilled` tells
/// whether the vessel contains contrast agent. The stations must be ordered along the vessel.
std::vector<FoundStation> searchedVessel(const CtVolume& ct, const std::vector<VesselStation>& expected, bool isFilled,
                                         const std::vector<TakenStation>& taken, Work& work);

}  // namespace insonate::segmentation
