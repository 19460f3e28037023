#pragma once

#include <hwy/aligned_allocator.h>

#include <algorithm>
#include <cstddef>

namespace insonate::display {

/// A grid of floats, initially zero, [row][column], with a margin for filters on both sides of each row. The columns
/// after the last, up to a whole number of vectors, may also be written.
class Plane {
 public:
  static constexpr int kMargin = 32;  ///< number of columns in the margin on each side of a row
  static constexpr int kVector = 16;  ///< rows are computed in multiples of this many columns (SIMD vectors)

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
  /// Returns a pointer to column 0 of a row. For a row outside the grid, returns a pointer to column 0 of the nearest
  /// existing row.
  float* row(int r) { return data_.get() + std::size_t(std::clamp(r, 0, rows_ - 1)) * stride_ + kMargin; }
  const float* row(int r) const { return const_cast<Plane*>(this)->row(r); }
  void clear() { std::fill_n(data_.get(), std::size_t(rows_) * stride_, 0.0F); }
  /// Fills the margins of a row with its first and its last column.
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
