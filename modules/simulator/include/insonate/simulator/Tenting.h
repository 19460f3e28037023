#pragma once

#include <insonate/core/Transform.h>
#include <insonate/image/PlaneDisplacement.h>

namespace insonate {

/// Tenting: the displacement of tissue that a needle's tip pushes ahead before it punctures a wall. Patient LPS,
/// millimeters.
struct Tenting {
  Vec3 tip_mm{};            ///< present position of the tip, in contact with the wall
  Vec3 direction{0, 0, 1};  ///< unit direction of the needle, toward the tip
  /// Distance by which the tip has pushed the tissue ahead; at most 30; 0 or less: no tenting.
  double depth_mm = 0;
  /// Radius of the tissue that the tip pushes ahead; 1 to 30. The radius is enlarged if the tissue would otherwise
  /// fold.
  double radius_mm = 3;

  bool operator==(const Tenting&) const = default;
};

/// Adds tenting to the displacement of tissue by a probe.
///
/// The displacement is a regularized Kelvinlet of incompressible tissue (de Goes and James, "Regularized Kelvinlets",
/// ACM Transactions on Graphics 36(4), 2017, equation 6 with nu = 1/2, two scales e and 2e subtracted). A Kelvinlet is
/// the displacement of an infinite elastic medium by a force that is distributed over a ball of radius e. With one
/// scale, the displacement decreases as 1/r, with two scales as 1/r^3. Two scales are used, since the friction of the
/// shaft and the probe hold the surrounding tissue. A window function reduces the displacement to zero at 6 e. The
/// volume of tissue is preserved, except for a few percent due to the window. |gradient| <= 1.02 depth / e (computed on
/// a grid); with e at least 1.2 depth, the gradient is below 0.86 and the tissue cannot fold.
class TentedTissue {
 public:
  /// Returns the displacement `pressed` with the tenting added, in the probe frame; `pressed` itself if the tenting
  /// does not reach the image plane. The result is valid until the next call, and only as long as `pressed`. Allocates
  /// nothing after a call with a tenting at least as large.
  const PlaneDisplacement& addTenting(const PlaneDisplacement& pressed, const Transform& patientFromProbe,
                                      const Tenting& tenting);

 private:
  PlaneDisplacement dented_;
};

}  // namespace insonate
