#pragma once

#include "DisplayPlan.h"
#include "Plane.h"

namespace insonate::display {

/// Variance-adaptive smoothing of levels in dB. Log-compressed speckle varies equally strongly at any brightness, so
/// stronger variation along one direction is an interface: it is smoothed along its own direction only (edges stay
/// sharp, grain stretches along them), plain speckle in all directions. The direction comes from the structure tensor,
/// J = <grad u grad u^T> (Weickert, Coherence-enhancing diffusion filtering, 1999), taken in units of the
/// point-spread function, in which speckle has no direction of its own.
class InterfaceSmoothing {
 public:
  /// `strength`: share of the smoothed levels in what smooth() writes, up to 1; the rest is what came in.
  InterfaceSmoothing(const DisplayPlan& plan, double strength);

  /// Finds the interfaces of an image from `levels` averaged over blocks; both with extended rows.
  void analyse(const Plane& blockLevels);
  /// One smoothed row; room for whole vectors in `out`.
  void smooth(const DisplayPlan& plan, const Plane& levels, int row, float* out) const;

 private:
  void smoothMean(const Plane& blockLevels, int block);
  void findGradients(int block);
  void findInterface(int block);

  std::vector<Block> blocks_;
  int columns_;
  float strength_;
  Plane mean_, xx_, xz_, zz_, structure_, edge_, slope_;
};

}  // namespace insonate::display
