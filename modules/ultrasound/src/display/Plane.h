#pragma once

#include <hwy/aligned_allocator.h>

#include <algorithm>
#include <cstddef>

namespace insonate::display {

/// A grid of floats, initially zero, [row][column], with room for filters on both sides of each row. The columns after
/// the last, up to a whole number of vectors, may also be written.
class Plane {
 public:
  static constexpr int kMargin = 32;  ///< columns on each side
  static constexpr int kVector = 16;  ///< rows are computed in multiples of this many columns

  Plane(int rows, int columns)
      : rows_(rows),
        columns_(columns),
        stride_(padded(columns) + 2 * kMargin),
        data_(hwy::AllocateAligned<float>(std::size_t(rows) * stride_)) {
    clear();
  }

  static int padded(int columns) { return (columns + kVector - 1) / kVector * kVector; }
  int rows() const { return rows_; }
  int stride() const { return stride_; }
  /// Column 0 of the row; for a row outside the grid, of the nearest existing row.
  float* row(int r) { return data_.get() + std::size_t(std::clamp(r, 0, rows_ - 1)) * stride_ + kMargin; }
  const float* row(int r) const { return const_cast<Plane*>(this)->row(r); }
  void clear() { std::fill_n(data_.get(), std::size_t(rows_) * stride_, 0.0F); }
  /// Repeats the first and the last column into the margins.
  void extendRow(int r) {
    float* const first = row(r);
    std::fill_n(first - kMargin, kMargin, first[0]);
    std::fill_n(first + columns_, stride_ - kMargin - columns_, first[columns_ - 1]);
  }

 private:
  int rows_, columns_, stride_;
  hwy::AlignedFreeUniquePtr<float[]> data_;
};

}  // namespace insonate::display
