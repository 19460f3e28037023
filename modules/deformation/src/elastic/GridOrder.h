#pragma once

#include <cstdint>
#include <vector>

namespace insonate::elastic {

/// Nested dissection of a grid of nodes, each with two unknowns and coupled to its eight neighbors (A. George, SIAM J.
/// Numer. Anal. 10, 1973): in which order unknowns are eliminated, and where each front lies. Depends on the size
/// alone, so that it is worked out once for a mesh.
class GridOrder {
 public:
  /// Unknowns eliminated together. Its front holds its own unknowns and the border, those of later fronts that they are
  /// coupled to: the nodes around the rectangle that has been eliminated so far.
  struct Front {
    int first = 0, own = 0;   ///< unknowns, in elimination order
    int border = 0;           ///< unknowns
    int firstBorder = 0;      ///< in borderUnknowns()
    int stride = 0;           ///< of the panel's and the update's rows, floats
    std::size_t panel = 0;    ///< where the factor's rows begin, floats
    int depth = 0, side = 0;  ///< which buffer the update goes to
    int child[2] = {-1, -1};
    int firstRun = 0, runs = 0;       ///< where the update goes in the parent's front
    int firstEntry = 0, entries = 0;  ///< of the matrix
  };
  /// Consecutive unknowns of a border, and their places in the parent's front.
  struct Run {
    int from = 0, to = 0, count = 0;
  };
  /// A coupling of two nodes, and where it goes.
  struct Entry {
    std::int32_t node = 0, at = 0;  ///< `at` in the panel
    std::int8_t block = 0;          ///< of GridMatrix
    bool transposed = false;
  };

  /// Prepares a grid of this size. Keeps its memory: a size not larger than an earlier one allocates nothing.
  void arrange(int columns, int rows);

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  int unknowns() const { return 2 * columns_ * rows_; }
  /// Fronts in the order of elimination; children come before their parent.
  const std::vector<Front>& fronts() const { return fronts_; }
  const std::vector<int>& borderUnknowns() const { return border_; }
  const std::vector<Run>& runs() const { return runs_; }
  const std::vector<Entry>& entries() const { return entries_; }
  /// The first of a node's two places in the order.
  const std::vector<int>& placeOfNode() const { return place_; }
  std::size_t factorSize() const { return factorSize_; }
  /// Floats of the largest update at each depth.
  const std::vector<std::size_t>& updateSize() const { return updateSize_; }

 private:
  struct Rectangle {
    int left, right, top, bottom;  ///< right and bottom are one past the last
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
    Rectangle whole, own;  ///< what a front and those before it eliminate, and it alone
  };
  std::vector<Part> parts_;
  std::size_t factorSize_ = 0;
  std::vector<std::size_t> updateSize_;
  int next_ = 0;
};

}  // namespace insonate::elastic
