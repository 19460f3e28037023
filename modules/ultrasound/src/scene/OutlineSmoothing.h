#pragma once

#include "scene/NodeLattice.h"

#include <array>
#include <vector>

namespace insonate {

/// Smooths the outlines of structures on a block of nodes, within the uncertainty of the label map. Its buffers are
/// reused for the next block; one thread at a time.
class OutlineSmoothing {
 public:
  /// Finds the smoothest outline that differs from the label map's outline by at most NodeLattice::freedom_mm: details
  /// smaller than a voxel may be smoothed, larger details may not. (Constrained elastic surface nets, S. F. Gibson
  /// 1998, applied to distances.) `d_mm` holds the signed distances at the nodes of the block. Distances at the block's
  /// sides are not changed, except at the end of the lattice, where filters repeat the last node beyond the end.
  void roundStairs(const NodeLattice& lattice, const NodeBox& block, const Stopped& stopped, std::vector<float>& d_mm);

 private:
  using Kernel = std::vector<float>;  ///< half of a symmetric filter kernel, center first
  using Kernels = std::array<Kernel, 3>;
  struct Range {
    int first, last;  ///< first node to filter, and the node after the last
  };
  static Kernels gaussians(const NodeLattice& lattice, double factor);
  Range inner(int axis, const Kernel& kernel) const;
  void lowPass(const Kernels& kernels, std::vector<float>& d);
  void smooth(const Kernels& kernels, const std::vector<float>& in, std::vector<float>& out);
  void alongX(const Kernel& kernel, const float* in, float* out);  ///< of one slice
  void alongY(const Kernel& kernel, const float* in, float* out);  ///< of one slice
  void alongZ(const Kernel& kernel, const std::vector<float>& in, std::vector<float>& out);

  std::array<int, 3> size_{};
  /// [axis] true if the block's low or high side is the end of the lattice.
  std::array<bool, 3> endsLow_{}, endsHigh_{};
  std::vector<float> original_, once_, planes_, slice_, padded_, filtered_;
  std::vector<const float*> rows_;
};

}  // namespace insonate
