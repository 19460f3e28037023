#pragma once

#include <insonate/core/Transform.h>
#include <insonate/image/PlaneDisplacement.h>

namespace insonate {

/// Rest point minus seen point, in the probe frame (no y), for a seen point of the probe's plane. Zero where nothing
/// has moved.
Vec3 shiftAt(const PlaneDisplacement& displacement, double x_mm, double z_mm);

/// Share of a cell's area that tissue in it had at rest is at least this, where slopes divide by it.
inline constexpr double kLeastVolume = 0.01;

/// Where a point at rest is seen, both in the probe frame: x + shift(x) = rest, solved by Newton's method on the
/// lattice's bilinear cells; within 0.001 mm unless the displacement folds.
Vec3 seenFromRest(const PlaneDisplacement& displacement, Vec3 rest_mm);

}  // namespace insonate
