#pragma once

#include <insonate/core/Transform.h>
#include <insonate/haptics/TissueGrid.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>

namespace insonate {

/// A flat piece of skin before one point of the probe's face, with its resistance.
struct SkinPatch {
  Vec3 onProbe_mm;              ///< the point of the face, probe frame
  Vec3 skin_mm;                 ///< a point of the skin at rest, patient space
  Vec3 outward{0, 0, -1};       ///< unit normal of the skin, patient space
  double stiffness_Npmm = 0;    ///< k1 of the force k1 d + k2 d^2, with d the depth of the face's point below the skin
  double stiffening_Npmm2 = 0;  ///< k2, not below 0
  bool operator==(const SkinPatch&) const = default;
};

/// Surroundings that the hands can feel, as slower threads computed them last; updated tens of times per second.
struct LocalModel {
  std::int64_t time_ns = 0;  ///< time at which the model was made, CLOCK_MONOTONIC; forces fade if the model is old
  std::shared_ptr<const TissueGrid> grid;  ///< tissue at rest; null: the needle feels no force
  Transform restFromPatient;  ///< maps to the place of the tissue at rest, near the needle's tip; affine, close to the
                              ///< identity
  std::array<SkinPatch, 4> patches;
  int patchCount = 0;
};

/// Sets k1 and k2 of a patch from one solution of the tissue: `force_N` at `indent_mm` (above 0), with slope
/// `slope_Npmm`. If the slope is below force over depth, or so steep that k1 would be negative, the closest possible
/// values are taken.
inline void setPatchForce(SkinPatch& patch, double force_N, double indent_mm, double slope_Npmm) {
  const double secant = force_N / indent_mm;
  patch.stiffening_Npmm2 = std::clamp((slope_Npmm - secant) / indent_mm, 0.0, secant / indent_mm);
  patch.stiffness_Npmm = secant - patch.stiffening_Npmm2 * indent_mm;
}

}  // namespace insonate
