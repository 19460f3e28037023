#pragma once

#include <insonate/core/Transform.h>
#include <insonate/image/PlaneDisplacement.h>

namespace insonate {

/// Share of a cell's area that tissue in it had at rest is at least this, where slopes divide by it.
inline constexpr double kLeastVolume = 0.01;

/// Displayed position of a point at rest, both in the probe frame: x + shift(x) = rest, solved by Newton's method on
/// the lattice's bilinear cells; within 0.001 mm unless the displacement folds.
Vec3 seenFromRest(const PlaneDisplacement& displacement, Vec3 rest_mm);

}  // namespace insonate
