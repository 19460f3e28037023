#pragma once

#include "BloodLevel.h"
#include "ClosedWay.h"

#include <insonate/segmentation/VesselTracking.h>

#include <vector>

namespace insonate::segmentation {

/// Finds the wall of a vessel in sections.
class OutlineFit {
 public:
  OutlineFit(const CtVolume& blurred, double smoothing_mm, double largest_mm);

  /// The best radii about the outline's centre, in its plane. Where `expected` is given, radii like its cost less.
  void fit(VesselOutline& outline, const BloodLevel& level, const Radii* expected) const;

  /// Moves radii that fit() has found to where the CT is half-way from the blood to what lies behind the wall there.
  void refine(VesselOutline& outline, const BloodLevel& level) const;

 private:
  static constexpr double kStep_mm = 0.25;

  Vec3 stepAlong(const VesselOutline& outline, int ray) const;
  std::vector<double> profile(const VesselOutline& outline, int ray, int samples) const;

  const CtVolume& ct_;
  Transform indexFromPatient_;
  int steps_;
  double blur_mm2_;  ///< variance of all blur that is known
};

}  // namespace insonate::segmentation
