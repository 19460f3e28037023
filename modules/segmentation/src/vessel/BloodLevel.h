#pragma once

#include <insonate/image/Volume.h>

namespace insonate::segmentation {

/// How bright blood is, and from where on it is something else.
struct BloodLevel {
  double low_HU = 0, blood_HU = 0, high_HU = 0;
  double half_HU = 0;  ///< half-way to the darker tissue around

  /// 0 where it is as bright as the blood, 1 at the limits, 4 at most.
  double unlikeness(double hu) const;
};

/// Around a point in blood, patient mm, of a CT that has been blurred. Its limits are nearer than half-way to the
/// darker tissue within `reach_mm`: a vein beside an artery differs by less than tissue does.
BloodLevel bloodAt(const CtVolume& ct, Vec3 patient_mm, double reach_mm);

/// `share` from a to b.
BloodLevel mixed(const BloodLevel& a, const BloodLevel& b, double share);

}  // namespace insonate::segmentation
