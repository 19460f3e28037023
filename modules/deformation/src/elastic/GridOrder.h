#pragma once

#include <cstdint>
#include <vector>

namespace insonate::elastic {

/// Nested dissection of a grid of nodes, each with two unknowns and coupled to its eight neighbors (A. George, SIAM J.
/// Numer. Anal. 10, 1973): the order in which unknowns are eliminated, and the position of each front in memory.
/// Depends only on the grid's size and is computed once per mesh.
class GridOrder {
 public:
  /// A front of the elimination: a group of unknowns that are eliminated together (own unknowns), and its border, the
  /// unknowns of later fronts that are coupled to the group. The border's nodes surround the rectangle of nodes that
  /// has been eliminated so far.
  struct Front {
    int first = 0, own = 0;   ///< index of the first own unknown in elimination order, and number of own unknowns
    int border = 0;           ///< number of unknowns in the border
    int firstBorder = 0;      ///< index of the front's first border unknown in borderUnknowns()
    int stride = 0;           ///< row length of the front's panel (its part of the factor) and of its update, floats
    std::size_t panel = 0;    ///< offset of the front's rows in the factor, floats
    int depth = 0, side = 0;  ///< indices of the buffer that receives the front's update
    int child[2] = {-1, -1};
    /// First entry and number of entries of runs() that place the update in the parent's front.
    int firstRun = 0, runs = 0;
    int firstEntry = 0, entries = 0;  ///< first index and number of the entries() that assemble the front
  };
  /// Consecutive unknowns of a border, and their positions in the parent's front.
  struct Run {
    int from = 0, to = 0, count = 0;
  };
  /// A coupling of two nodes, and its position in the front.
  struct Entry {
    /// `node`: the node in whose blocks the matrix stores the coupling; `at`: position of the coupling in the front's
    /// panel.
    std::int32_t node = 0, at = 0;
    std::int8_t block = 0;  ///< block of the coupling in the matrix (GridMatrix::Block)
    bool transposed = false;
  };

  /// Prepares a grid of this size. Allocates only if the grid is larger than every earlier one.
  void arrange(int columns, int rows);

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  int unknowns() const { return 2 * columns_ * rows_; }
  /// Returns the fronts in the order of elimination; children precede their parent.
  const std::vector<Front>& fronts() const { return fronts_; }
  const std::vector<int>& borderUnknowns() const { return border_; }
  const std::vector<Run>& runs() const { return runs_; }
  const std::vector<Entry>& entries() const { return entries_; }
  /// Returns, for each node, the position of the first of its two unknowns in the elimination order.
  const std::vector<int>& placeOfNode() const { return place_; }
  std::size_t factorSize() const { return factorSize_; }
  /// Returns the size of the largest update at each depth of the dissection, floats.
  const std::vector<std::size_t>& updateSize() const { return updateSize_; }

 private:
  struct Rectangle {
    /// Rectangle of nodes: first column and row; right and bottom are one past the last column and row.
    int left, right, top, bottom;
  };
  int dissect(Rectangle r, int depth, int side);
  void close(int front);
  void connect(const Front& parent, int child);
  int localPlace(const Front& front, int unknown) const;

  int columns_ = 0, rows_ = 0;
  std::vector<Front> fronts_;
  std::vector<int> border_, place_;
  std::vector<Run> runs_;
  std::vector<Entry> entries_;
  struct Part {
    /// `whole`: nodes eliminated up to and including a front; `own`: nodes eliminated by this front only.
    Rectangle whole, own;
  };
  std::vector<Part> parts_;
  std::size_t factorSize_ = 0;
  std::vector<std::size_t> updateSize_;
  int next_ = 0;
};

}  // namespace insonate::elastic
