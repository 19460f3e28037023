#pragma once

#include "Anatomy.h"
#include "phantom/RegionModel.h"

namespace insonate::phantom {

/// Model of a whole neck, or of the region below the clavicles.
class NeckModel : public RegionModel {
 public:
  NeckModel(const NeckParameters& parameters, std::uint32_t seed);

  /// Returns the center of an internal jugular vein at a level, patient mm.
  Vec3 jugularCenter_mm(Side side, double z_mm) const;
  /// Returns the center of an axillary vein at a distance from the midline, patient mm.
  Vec3 axillaryCenter_mm(Side side, double lateral_mm) const;

 private:
  NeckParameters parameters_;
};

}  // namespace insonate::phantom
