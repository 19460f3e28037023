#pragma once

#include "SliceCell.h"

#include <insonate/image/Volume.h>
#include <insonate/views/SlicePlane.h>

#include <array>
#include <optional>
#include <vector>

namespace insonate::views {

/// The columns of a slice whose rows run along one axis of the grid, as those of most scans do. They cut that axis at
/// the same places in every row: what lies across a row is mixed once for its voxels, not for each of its pixels.
class AlignedColumns {
 public:
  struct Column {
    SliceCell cell;
    int nearest;         ///< voxel
    std::size_t offset;  ///< of that voxel from voxel 0 of the axis
  };
  /// A row that meets the grid.
  struct Row {
    std::array<SliceCell, 2> across;  ///< along the other axes, in their order
    std::array<int, 3> nearest;       ///< voxel, at 0 along its own axis
  };

  /// Aligns with a plane; false if its rows are oblique to the grid.
  bool place(const VolumeGeometry& grid, const SlicePlane& plane);

  /// Samples of a row; none for a row outside the grid.
  std::optional<Row> row(const VolumeGeometry& grid, const SlicePlane& plane, int row) const;
  /// `line` is work space. The values of columns first() to end() are then hu(line, column).
  void mix(const CtVolume& ct, const Row& row, std::vector<float>& line) const;
  int hu(const std::vector<float>& line, int column) const;

  /// Columns within the grid.
  int first() const { return first_; }
  int end() const { return first_ + int(columns_.size()); }
  const Column& column(int column) const { return columns_[std::size_t(column - first_)]; }
  int axis() const { return axis_; }

 private:
  int axis_ = 0;
  std::array<int, 2> across_{1, 2};  ///< the other axes
  std::array<std::size_t, 3> strides_{};
  int first_ = 0;
  int firstVoxel_ = 0, endVoxel_ = 0;  ///< that the columns lie between
  std::vector<Column> columns_;
};

}  // namespace insonate::views
