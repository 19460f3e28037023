#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/segmentation/Region.h>

namespace insonate {

/// Parameters of a surface that moves outward, stays smooth and is stopped by edges of the CT: V. Caselles, R. Kimmel,
/// G. Sapiro, "Geodesic active contours", IJCV 22, 1997.
struct GeodesicLevelSet {
  double edge_HUpmm = 30;     ///< gradient at which the speed is one half; above 0
  double smoothing_mm = 0.8;  ///< standard deviation of the blur before the gradient; 0 or more
  double propagation = 1;     ///< speed outward; negative for inward
  double curvature = 0.3;     ///< weight of smoothness; 0 or more
  double advection = 1;       ///< weight of the attraction by edges; 0 or more
  int rounds = 120;           ///< maximum number of iterations; stops earlier if the surface no longer moves
};

/// Returns the region inside a surface that starts as the surface of `start`. The surface stays within the selection's
/// box, which must leave space for growth. Refuses an empty start; fails when cancelled.
Result<Selection> levelSet(const CtVolume& ct, const Selection& start, const GeodesicLevelSet& parameters,
                           const Progress& progress = {});

}  // namespace insonate
