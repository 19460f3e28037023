#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/segmentation/Region.h>

namespace insonate {

/// Parameters of a surface that moves outward, stays smooth and is stopped by edges of the CT: V. Caselles, R. Kimmel,
/// G. Sapiro, "Geodesic active contours", IJCV 22, 1997.
struct GeodesicLevelSet {
  double edge_HUpmm = 30;     ///< CT gradient at which the surface moves at half speed; above 0
  double smoothing_mm = 0.8;  ///< standard deviation of the CT's blur before the gradient is computed; 0 or more
  double propagation = 1;     ///< outward speed of the surface; negative for inward
  double curvature = 0.3;     ///< weight of the surface's smoothness; 0 or more
  double advection = 1;       ///< weight of the attraction of the surface by edges of the CT; 0 or more
  int rounds = 120;  ///< maximum number of iterations; the iteration ends earlier if the surface no longer moves
};

/// Moves the surface of the region `start`, and returns the region inside the final surface. The surface stays within
/// the box of `start`, which must leave space for growth. Refuses an empty start; fails when cancelled.
Result<Selection> levelSet(const CtVolume& ct, const Selection& start, const GeodesicLevelSet& parameters,
                           const Progress& progress = {});

}  // namespace insonate
