#pragma once

#include "scene/NodeLattice.h"

#include <array>
#include <vector>

namespace insonate {

/// Rounds the outlines of structures on a block of nodes, as far as a label map leaves open where they run. Keeps its
/// buffers from block to block; one thread at a time.
class OutlineSmoothing {
 public:
  /// The smoothest outline that stays within the lattice's freedom of the label map's: what a voxel does not resolve
  /// may be rounded, what it does may not. (Constrained elastic surface nets, S. F. Gibson 1998, on distances.)
  /// `d_mm` holds the nodes of the block. Those at its sides stay as they are, but where the block ends with the
  /// lattice: there the last node continues outside.
  void roundStairs(const NodeLattice& lattice, const NodeBox& block, const Stopped& stopped, std::vector<float>& d_mm);

 private:
  using Kernel = std::vector<float>;  ///< half of it, center first
  using Kernels = std::array<Kernel, 3>;
  struct Range {
    int first, last;  ///< nodes to be filtered; the last is beyond
  };
  static Kernels gaussians(const NodeLattice& lattice, double factor);
  Range inner(int axis, const Kernel& kernel) const;
  void lowPass(const Kernels& kernels, std::vector<float>& d);
  void smooth(const Kernels& kernels, std::vector<float>& d);
  void alongX(const Kernel& kernel, const std::vector<float>& in, std::vector<float>& out);
  void alongY(const Kernel& kernel, const std::vector<float>& in, std::vector<float>& out);
  void alongZ(const Kernel& kernel, const std::vector<float>& in, std::vector<float>& out);

  std::array<int, 3> size_{};
  std::array<bool, 3> endsLow_{}, endsHigh_{};  ///< the block ends with the lattice
  std::vector<float> original_, once_, scratch_, padded_, filtered_;
  std::vector<const float*> rows_;
};

}  // namespace insonate
