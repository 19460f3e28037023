#pragma once

#include <insonate/core/Transform.h>
#include <insonate/image/PlaneDisplacement.h>

namespace insonate {

/// Minimum of the ratio of a lattice cell's area at rest to its displaced area; a limit, since slopes are divided by
/// this ratio.
inline constexpr double kLeastVolume = 0.01;

/// Returns the displayed position of a tissue point from its rest position, both in the probe frame. Solves x +
/// shift(x) = rest by Newton's method on the lattice's bilinear cells; exact to 0.001 mm unless the displacement folds.
Vec3 seenFromRest(const PlaneDisplacement& displacement, Vec3 rest_mm);

}  // namespace insonate
