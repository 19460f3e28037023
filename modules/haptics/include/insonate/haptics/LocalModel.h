#pragma once

#include <insonate/core/Transform.h>
#include <insonate/haptics/TissueGrid.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>

namespace insonate {

/// Plane that approximates the skin near one point of the probe's face, with the skin's resistance.
struct SkinPatch {
  Vec3 onProbe_mm;         ///< point of the probe's face to which this patch belongs, probe frame
  Vec3 skin_mm;            ///< a point of the undeformed skin, patient space
  Vec3 outward{0, 0, -1};  ///< unit normal of the skin, patient space
  /// k1 of the skin's force on the probe, k1 d + k2 d^2; d is the depth of `onProbe_mm` below the undeformed skin.
  double stiffness_Npmm = 0;
  double stiffening_Npmm2 = 0;  ///< k2 of the skin's force on the probe, k1 d + k2 d^2; 0 or more
  bool operator==(const SkinPatch&) const = default;
};

/// Tissue near probe and needle, from which the force loop computes forces. Slower threads update the tissue tens of
/// times per second.
struct LocalModel {
  /// time at which the model was made, CLOCK_MONOTONIC; forces decrease to zero if the model is old
  std::int64_t time_ns = 0;
  std::shared_ptr<const TissueGrid> grid;  ///< undeformed tissue; null: no force acts on the needle
  /// Affine map from the present to the undeformed position of tissue near the needle's tip, patient space; close to
  /// the identity.
  Transform restFromPatient;
  std::array<SkinPatch, 4> patches;
  int patchCount = 0;
};

/// Sets the stiffness k1 and stiffening k2 of a patch so that its force is `force_N` and the derivative of the force is
/// `slope_Npmm` at the depth `indent_mm` (above 0). The slope is clamped so that k1 and k2 are not negative.
inline void setPatchForce(SkinPatch& patch, double force_N, double indent_mm, double slope_Npmm) {
  const double secant = force_N / indent_mm;
  patch.stiffening_Npmm2 = std::clamp((slope_Npmm - secant) / indent_mm, 0.0, secant / indent_mm);
  patch.stiffness_Npmm = secant - patch.stiffening_Npmm2 * indent_mm;
}

}  // namespace insonate
