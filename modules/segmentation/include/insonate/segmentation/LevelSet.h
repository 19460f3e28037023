#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/segmentation/Region.h>

namespace insonate {

/// A surface that moves outward, stays smooth, and is held by edges of the CT:
/// V. Caselles, R. Kimmel, G. Sapiro, "Geodesic active contours", IJCV 22, 1997.
struct GeodesicLevelSet {
  double edge_HUpmm = 30;     ///< the steepness that halves its speed; above 0
  double smoothing_mm = 0.8;  ///< standard deviation of the blur before the gradient; 0 or more
  double propagation = 1;     ///< outward; negative for inward
  double curvature = 0.3;     ///< how much it is kept smooth; 0 or more
  double advection = 1;       ///< how much edges pull it; 0 or more
  int rounds = 120;           ///< at most; it stops earlier where it rests
};

/// Returns the region inside a surface that starts as that of `start`, in the selection's box: give the box room to
/// grow into. Refuses an empty start; fails when cancelled.
Result<Selection> levelSet(const CtVolume& ct, const Selection& start, const GeodesicLevelSet& parameters,
                           const Progress& progress = {});

}  // namespace insonate
