#include "elastic/GridOrder.h"

#include "elastic/GridMatrix.h"

#include <algorithm>

namespace insonate::elastic {
namespace {

constexpr int kLeafNodes = 12;
constexpr int kStrideUnit = 8;
constexpr int kSlack = 16;  // the right-hand side, and room for whole vectors

/// Odd multiples of the unit, so that rows are distributed over all sets of a cache.
int roundedUp(int n) {
  return ((n + kStrideUnit - 1) / kStrideUnit | 1) * kStrideUnit;
}

}  // namespace

void GridOrder::arrange(int columns, int rows) {
  columns_ = columns, rows_ = rows;
  fronts_.clear(), parts_.clear(), border_.clear(), runs_.clear(), entries_.clear(), updateSize_.clear();
  factorSize_ = 0;
  next_ = 0;
  place_.assign(std::size_t(columns) * rows, -1);
  dissect({0, columns, 0, rows}, 0, 0);
  for (int f = 0; f < static_cast<int>(fronts_.size()); ++f) close(f);
  for (const Front& front : fronts_)
    for (const int child : front.child)
      if (child >= 0) connect(front, child);
}

int GridOrder::dissect(Rectangle r, int depth, int side) {
  const int width = r.right - r.left, height = r.bottom - r.top;
  if (width <= 0 || height <= 0) return -1;
  Front front;
  Rectangle line = r;
  if (width * height > kLeafNodes) {
    Rectangle a = r, b = r;
    if (width >= height) {
      const int middle = r.left + width / 2;
      a.right = line.left = middle;
      b.left = line.right = middle + 1;
    } else {
      const int middle = r.top + height / 2;
      a.bottom = line.top = middle;
      b.top = line.bottom = middle + 1;
    }
    front.child[0] = dissect(a, depth + 1, 0);
    front.child[1] = dissect(b, depth + 1, 1);
  }
  front.depth = depth;
  front.side = side;
  front.first = next_;
  for (int j = line.top; j < line.bottom; ++j)
    for (int i = line.left; i < line.right; ++i, next_ += 2) place_[j * columns_ + i] = next_;
  front.own = next_ - front.first;
  fronts_.push_back(front);
  parts_.push_back({r, line});
  return static_cast<int>(fronts_.size()) - 1;
}

void GridOrder::close(int f) {
  Front& front = fronts_[f];
  const auto& [r, own] = parts_[f];
  front.firstBorder = static_cast<int>(border_.size());
  for (int j = std::max(r.top - 1, 0); j < std::min(r.bottom + 1, rows_); ++j)
    for (int i = std::max(r.left - 1, 0); i < std::min(r.right + 1, columns_); ++i)
      if (j < r.top || j >= r.bottom || i < r.left || i >= r.right) {
        border_.push_back(place_[j * columns_ + i]);
        border_.push_back(place_[j * columns_ + i] + 1);
      }
  std::sort(border_.begin() + front.firstBorder, border_.end());
  front.border = static_cast<int>(border_.size()) - front.firstBorder;
  front.stride = roundedUp(front.own + front.border + kSlack);
  front.panel = factorSize_;
  factorSize_ += std::size_t(front.own) * front.stride;
  if (static_cast<int>(updateSize_.size()) <= front.depth) updateSize_.resize(front.depth + 1);
  updateSize_[front.depth] = std::max(updateSize_[front.depth], std::size_t(front.border) * front.stride + kSlack);

  front.firstEntry = static_cast<int>(entries_.size());
  using M = GridMatrix;
  struct Neighbor {
    int di, dj, block;
  };
  static constexpr Neighbor kAfter[] = {
      {0, 0, M::Self}, {1, 0, M::East}, {-1, 1, M::SouthWest}, {0, 1, M::South}, {1, 1, M::SouthEast}};
  for (int j = own.top; j < own.bottom; ++j)
    for (int i = own.left; i < own.right; ++i) {
      const int a = j * columns_ + i;
      const int row = place_[a] - front.first;
      const auto add = [&](const Neighbor& n, bool transposed) {
        const int sign = transposed ? -1 : 1;
        const int ib = i + sign * n.di, jb = j + sign * n.dj;
        if (ib < 0 || jb < 0 || ib >= columns_ || jb >= rows_) return;
        const int b = jb * columns_ + ib;
        if (place_[b] < place_[a]) return;
        entries_.push_back({transposed ? b : a, row * front.stride + localPlace(front, place_[b]),
                            static_cast<std::int8_t>(n.block), transposed});
      };
      for (const Neighbor& n : kAfter) add(n, false);
      for (const Neighbor& n : kAfter)
        if (n.block != M::Self) add(n, true);
    }
  front.entries = static_cast<int>(entries_.size()) - front.firstEntry;
}

int GridOrder::localPlace(const Front& front, int unknown) const {
  if (unknown < front.first + front.own) return unknown - front.first;
  const auto begin = border_.begin() + front.firstBorder;
  return front.own + static_cast<int>(std::lower_bound(begin, begin + front.border, unknown) - begin);
}

void GridOrder::connect(const Front& parent, int childIndex) {
  Front& child = fronts_[childIndex];
  child.firstRun = static_cast<int>(runs_.size());
  for (int b = 0; b < child.border; ++b) {
    const int to = localPlace(parent, border_[child.firstBorder + b]);
    if (b > 0 && runs_.back().to + runs_.back().count == to)
      ++runs_.back().count;
    else
      runs_.push_back({b, to, 1});
  }
  child.runs = static_cast<int>(runs_.size()) - child.firstRun;
}

}  // namespace insonate::elastic
