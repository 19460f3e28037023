#pragma once

#include <array>
#include <vector>

namespace insonate::elastic {

/// A symmetric matrix over a grid of nodes with two unknowns each. Holds each node's own 2x2 block and its blocks with
/// four neighbors; the blocks with the other four neighbors follow by symmetry. Each entry of the blocks has an array
/// over all nodes, so that rows of nodes are processed as SIMD vectors.
struct GridMatrix {
  enum Block { Self, East, SouthWest, South, SouthEast, kBlocks };
  /// Returns the index in `value` of the first array of a block. The block Self has the arrays xx, xz, zz; other blocks
  /// have xx, xz, zx, zz (this node's unknown first).
  static constexpr int first(int block) { return block == Self ? 0 : 4 * block - 1; }
  static constexpr int kArrays = 19;
  static constexpr int kPadding = 64;  ///< floats beyond the last node, for whole SIMD vectors

  int columns = 0, rows = 0;
  std::array<std::vector<float>, kArrays> value;

  void resize(int c, int r) {
    columns = c, rows = r;
    for (auto& v : value) v.assign(std::size_t(c) * r + kPadding, 0.0f);
  }
};

}  // namespace insonate::elastic
