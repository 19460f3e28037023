#pragma once

#include <insonate/core/Result.h>
#include <insonate/core/Vec3.h>

namespace insonate {

/// A straight, hollow steel needle with a short bevel. The displacement of the tissue does not move the needle. Patient
/// LPS, millimeters. 18 G has an outer diameter of 1.27 mm (ISO 9626).
struct Needle {
  Vec3 tip_mm{};
  Vec3 direction{0, 0, 1};  ///< unit direction of the shaft, toward the tip
  /// direction toward which the opening of the bevel faces; only its component perpendicular to the shaft is used and
  /// must not be 0
  Vec3 bevelNormal{1, 0, 0};
  double radius_mm = 0.635;  ///< outer radius; 0.1 to 2
  double length_mm = 70;     ///< length from the tip to the hub; 1 to 300

  bool operator==(const Needle&) const = default;
};

/// Fails with a sentence on values that are not finite or out of range, on a direction that is not of unit length, and
/// on a bevel that faces along the shaft.
Result<void> validate(const Needle& needle);

}  // namespace insonate
