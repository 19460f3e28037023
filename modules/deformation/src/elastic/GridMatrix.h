#pragma once

#include <array>
#include <vector>

namespace insonate::elastic {

/// A symmetric matrix over a grid of nodes with two unknowns each: the node's own 2x2 block and those to four of its
/// neighbors; the other four follow by symmetry. One array a number, so that a row of nodes is worked on in vectors.
struct GridMatrix {
  enum Block { Self, East, SouthWest, South, SouthEast, kBlocks };
  /// First array of a block: xx, xz, zz of Self; xx, xz, zx, zz of others (this node's unknown first).
  static constexpr int first(int block) { return block == Self ? 0 : 4 * block - 1; }
  static constexpr int kArrays = 19;
  static constexpr int kPadding = 64;  ///< floats beyond the last node, for whole vectors

  int columns = 0, rows = 0;
  std::array<std::vector<float>, kArrays> value;

  void resize(int c, int r) {
    columns = c, rows = r;
    for (auto& v : value) v.assign(std::size_t(c) * r + kPadding, 0.0f);
  }
};

}  // namespace insonate::elastic
