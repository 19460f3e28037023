#pragma once

#include "DisplayPlan.h"
#include "Plane.h"

namespace insonate::display {

/// Variance-adaptive smoothing of levels in dB. The variance of log-compressed speckle is the same at any brightness,
/// so that a stronger variation in one direction indicates an interface. An interface is smoothed only along its own
/// direction (edges stay sharp, and speckle is stretched along them); plain speckle is smoothed in all directions. The
/// direction follows from the structure tensor, J = <grad u grad u^T> (Weickert, Coherence-enhancing diffusion
/// filtering, 1999), in units of the point-spread function, in which speckle has no preferred direction.
class InterfaceSmoothing {
 public:
  /// `strength` is the weight of the smoothed levels in the output of smooth(), 0 to 1; the rest are the input levels.
  InterfaceSmoothing(const DisplayPlan& plan, double strength);

  /// Finds the interfaces of an image from `blockLevels`, the levels averaged over blocks of rows, whose margins must
  /// be filled (Plane::extendRow()).
  void analyse(const Plane& blockLevels);
  /// Writes one smoothed row of levels to `out`, which must have room for whole SIMD vectors. The margins of `levels`
  /// must be filled.
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
