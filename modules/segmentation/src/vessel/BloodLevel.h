#pragma once

#include "Work.h"

#include <insonate/image/Volume.h>

#include <span>
#include <vector>

namespace insonate::segmentation {

/// CT value of blood, and the limits below and above which the CT shows other tissue.
struct BloodLevel {
  double low_HU = 0, blood_HU = 0, high_HU = 0;
  double half_HU = 0;  ///< CT value half-way between the blood and the darker tissue around it

  /// Returns the squared difference of `hu` from blood_HU, scaled to 0 at blood_HU and 1 at low_HU and high_HU; at most
  /// 4.
  double unlikeness(double hu) const;
};

/// Measures the CT value of blood and its limits around a point in blood (patient, mm) in a blurred CT. Each limit is
/// closer to the value of blood than the value half-way to the darker tissue within `reach_mm`, because a vein differs
/// less from an artery beside the vein than from other tissue.
BloodLevel bloodAt(const CtVolume& ct, Vec3 patient_mm, double reach_mm);

/// Interpolates linearly between two levels: returns a for `share` 0, b for `share` 1.
BloodLevel mixed(const BloodLevel& a, const BloodLevel& b, double share);

/// Returns a copy of `levels` (one per section along a vessel) in which the CT value of blood is the one measured in
/// the sections. Each value is the median over neighboring sections, so that the noise of a single section has little
/// effect. The CT values of the surrounding tissue stay those of `levels`.
std::vector<BloodLevel> measured(const std::vector<BloodLevel>& levels, const std::vector<double>& blood_HU);

/// Returns the level of blood at each click. `way_mm` is a path through the blood in steps of a millimeter; click n is
/// the point with the index `clickOnWay[n]` of this path. The ball around a click contains only a few voxels, whose
/// noise would affect the level up to the next click, whereas blood changes little along a vessel. The level is
/// therefore the median over the path around the click. Exception: the click's own level is used if it differs by more
/// than the scatter along the path explains, as at a thin end.
std::vector<BloodLevel> levelsAtClicks(const CtVolume& ct, std::span<const Vec3> clicks_mm,
                                       std::span<const Vec3> way_mm, std::span<const std::size_t> clickOnWay,
                                       double reach_mm, Work& work);

}  // namespace insonate::segmentation
