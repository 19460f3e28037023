#pragma once

#include "BloodLevel.h"
#include "ClosedWay.h"
#include "SectionShape.h"

#include <insonate/segmentation/VesselTracking.h>

#include <span>
#include <vector>

namespace insonate::segmentation {

/// Finds the wall of a vessel in sections along it. The CT is averaged over neighboring sections, but not blurred.
class OutlineFit {
 public:
  OutlineFit(const CtVolume& ct, double largest_mm);

  /// Returns the best radii around the n-th section's center, in its plane, along the rays of `shape`. If `expected` is
  /// given, radii close to it cost less.
  Radii fitted(const std::vector<VesselOutline>& sections, int n, const SectionShape& shape, const BloodLevel& level,
               const Radii* expected) const;

  /// Returns the CT value of blood in a section whose radii are from fitted(): the median along all rays, from the
  /// center to half the radius.
  double bloodIn(const VesselOutline& section, const SectionShape& shape) const;

  /// Returns the n-th section's radii from fitted(), moved to the position at which the CT is half-way between the
  /// blood and the tissue behind the wall.
  Radii refined(const std::vector<VesselOutline>& sections, int n, const SectionShape& shape,
                const BloodLevel& level) const;

 private:
  static constexpr double kStep_mm = 0.25;

  /// Returns CT values along a ray in the plane of the n-th section, averaged over neighboring sections: `samples`
  /// values at intervals of `step` (x and y, mm), beginning at `first` intervals from the center.
  std::vector<double> profile(const std::vector<VesselOutline>& sections, int n, std::pair<double, double> step,
                              double first, int samples) const;

  double widening_mm(double seen_mm) const;

  const CtVolume& ct_;
  Transform indexFromPatient_;
  int steps_;
  double blur_mm2_;  ///< variance of the CT's blur by scanner and voxels
  int reach_;        ///< maximum distance from a fitted wall at which refined() searches, in steps of kStep_mm
};

}  // namespace insonate::segmentation
