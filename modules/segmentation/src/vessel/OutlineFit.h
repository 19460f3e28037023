#pragma once

#include "BloodLevel.h"
#include "ClosedWay.h"
#include "SectionShape.h"

#include <insonate/segmentation/VesselTracking.h>

#include <span>
#include <vector>

namespace insonate::segmentation {

/// Finds the wall of a vessel in sections along it. The CT is averaged over the sections around instead of blurred.
class OutlineFit {
 public:
  OutlineFit(const CtVolume& ct, double largest_mm);

  /// The best radii about the n-th section's center, in its plane, along the rays of `shape`. Where `expected` is
  /// given, radii like its cost less.
  Radii fitted(const std::vector<VesselOutline>& sections, int n, const SectionShape& shape, const BloodLevel& level,
               const Radii* expected) const;

  /// Median HU of the CT in the inner half of a section whose radii fitted() has found.
  double bloodIn(const VesselOutline& section, const SectionShape& shape) const;

  /// The n-th section's radii that fitted() has found, moved to where the CT is half-way from the blood to what lies
  /// behind the wall there.
  Radii refined(const std::vector<VesselOutline>& sections, int n, const SectionShape& shape,
                const BloodLevel& level) const;

 private:
  static constexpr double kStep_mm = 0.25;

  /// Profile in steps of x and y mm in the plane of the n-th section, from `first` steps on.
  std::vector<double> profile(const std::vector<VesselOutline>& sections, int n, std::pair<double, double> step,
                              double first, int samples) const;

  double widening_mm(double seen_mm) const;

  const CtVolume& ct_;
  Transform indexFromPatient_;
  int steps_;
  double blur_mm2_;  ///< variance of all blur that is known
  int reach_;        ///< walls are moved by so many steps at most
};

}  // namespace insonate::segmentation
