#pragma once

#include "Work.h"

#include <insonate/image/Volume.h>

#include <span>
#include <vector>

namespace insonate::segmentation {

/// Brightness of blood, and the limits beyond which it is other tissue.
struct BloodLevel {
  double low_HU = 0, blood_HU = 0, high_HU = 0;
  double half_HU = 0;  ///< half-way to the darker tissue around

  /// 0 at the blood's brightness, 1 at the limits, 4 at most.
  double unlikeness(double hu) const;
};

/// Level around a point in blood, patient mm, of a blurred CT. Its limits are nearer than half-way to the darker
/// tissue within `reach_mm`: a vein beside an artery differs by less than tissue does.
BloodLevel bloodAt(const CtVolume& ct, Vec3 patient_mm, double reach_mm);

/// `share` from a to b.
BloodLevel mixed(const BloodLevel& a, const BloodLevel& b, double share);

/// The levels along a vessel, once sections are found in it: blood is as bright as it was measured in them, and as in
/// those around, since noise of a section would be its level's; the tissue around is as it was.
std::vector<BloodLevel> measured(const std::vector<BloodLevel>& levels, const std::vector<double>& blood_HU);

/// Levels at the clicks; each click is a point `clickOnWay` of a path through the blood in steps of a millimeter. A
/// click's ball is a few voxels, whose noise would set the level as far as the next click, and blood changes little
/// along a vessel: the level is therefore the median over the path around the click, unless the click's own differs by
/// more than the scatter along the path explains, as at a thin end.
std::vector<BloodLevel> levelsAtClicks(const CtVolume& ct, std::span<const Vec3> clicks_mm,
                                       std::span<const Vec3> way_mm, std::span<const std::size_t> clickOnWay,
                                       double reach_mm, Work& work);

}  // namespace insonate::segmentation
