#pragma once

#include "BloodLevel.h"

#include <insonate/segmentation/VesselTracking.h>

#include <optional>

namespace insonate::segmentation {

/// Finds the wall of a vessel in sections.
class OutlineFit {
 public:
  OutlineFit(const CtVolume& blurred, double largest_mm);

  /// The best radii about the outline's centre, in its plane. Where `expected` is given, radii like its cost less.
  void fit(VesselOutline& outline, const BloodLevel& level,
           const std::array<double, VesselOutline::kRays>* expected) const;

 private:
  static constexpr double kStep_mm = 0.25;

  const CtVolume& ct_;
  Transform indexFromPatient_;
  int steps_;
};

}  // namespace insonate::segmentation
