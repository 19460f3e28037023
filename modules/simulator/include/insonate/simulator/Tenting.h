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
/// A Kelvinlet is the displacement of an infinite elastic medium by a force that is distributed over a ball of radius e
/// (de Goes and James, "Regularized Kelvinlets", ACM Transactions on Graphics 36(4), 2017). Tenting is the difference
/// of two Kelvinlets of incompressible tissue, with the radii e and 2e (equation 6 with nu = 1/2). At the distance r, a
/// single Kelvinlet decreases as 1/r, the difference as 1/r^3. The faster decrease is used, since the probe, and
/// friction at the shaft, hold the surrounding tissue. A window function reduces the displacement to zero at 6 e. The
/// volume of tissue is preserved, except for a few percent due to the window.
///
/// The norm of the displacement's gradient is at most 1.02 times the depth of the tenting, divided by e (computed on a
/// grid). e is at least 1.2 times the depth of the tenting. The norm is therefore below 0.86, and the tissue cannot
/// fold.
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
