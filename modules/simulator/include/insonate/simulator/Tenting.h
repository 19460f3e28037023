#pragma once

#include <insonate/core/Transform.h>
#include <insonate/image/PlaneDisplacement.h>

namespace insonate {

/// Tissue that a needle pushes ahead of its tip before a wall gives way. Patient LPS, millimeters.
struct Tenting {
  Vec3 tip_mm{};            ///< where the tip is now, the wall on it
  Vec3 direction{0, 0, 1};  ///< of the needle, toward the tip; unit
  double depth_mm = 0;      ///< how far what is at the tip has been pushed along; 0 and less: nothing; at most 30
  double radius_mm = 3;     ///< of what goes along; 1..30. Where tissue would fold, it is taken larger

  bool operator==(const Tenting&) const = default;
};

/// Tissue displaced by a probe, dented by a needle's tip as well.
///
/// Kernel: regularised Kelvinlets of incompressible tissue (de Goes and James, "Regularized Kelvinlets", ACM
/// Transactions on Graphics 36(4), 2017, equation 6 with nu = 1/2, two scales e and 2e subtracted): what a force spread
/// over a ball of radius e does to an infinite elastic medium. One scale fades as 1/r; two as 1/r^3, since the shaft's
/// friction and the probe hold what is pushed. A window takes it to nothing at 6 e. Volume is kept, but for the
/// window's few percent. |gradient| <= 1.02 depth / e (computed on a grid): with e at least 1.2 depth, it is below 0.86
/// and tissue cannot fold.
class TentedTissue {
 public:
  /// `pressed` with the dent, in the frame of `patientFromProbe`; the same object where there is no dent in reach of
  /// the plane. Valid until the next call, and while `pressed` is. Allocates nothing once called with as large a dent.
  const PlaneDisplacement& with(const PlaneDisplacement& pressed, const Transform& patientFromProbe,
                                const Tenting& tenting);

 private:
  PlaneDisplacement dented_;
};

}  // namespace insonate
