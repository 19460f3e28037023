#pragma once

#include "SliceCell.h"

#include <insonate/image/Volume.h>
#include <insonate/views/SlicePlane.h>

#include <array>
#include <optional>
#include <vector>

namespace insonate::views {

/// Speeds up the sampling of slices whose rows are parallel to an axis of the grid, as in most scans. All rows of such
/// a slice have the same sample positions along this axis. The interpolation across a row is therefore computed once
/// per voxel instead of once per pixel.
class AlignedColumns {
 public:
  struct Column {
    SliceCell cell;
    int nearest;         ///< index of the nearest voxel along the axis
    std::size_t offset;  ///< offset in memory from voxel 0 of the axis to that voxel
  };
  /// Position of a row that intersects the grid.
  struct Row {
    std::array<SliceCell, 2> across;  ///< cells along the other two axes, in their order
    std::array<int, 3> nearest;       ///< nearest voxel; its index along the row's axis is 0
  };

  /// Prepares the columns for a plane; returns false if the plane's rows are oblique to the grid.
  bool place(const VolumeGeometry& grid, const SlicePlane& plane);

  /// Returns the position of a row; empty for a row outside the grid.
  std::optional<Row> row(const VolumeGeometry& grid, const SlicePlane& plane, int row) const;
  /// Interpolates the voxels of a row into `line`. After this, hu(line, column) is valid for columns first() to end().
  void mix(const CtVolume& ct, const Row& row, std::vector<float>& line) const;
  int hu(const std::vector<float>& line, int column) const;

  /// first() returns the first column within the grid, end() the column after the last.
  int first() const { return first_; }
  int end() const { return first_ + int(columns_.size()); }
  const Column& column(int column) const { return columns_[std::size_t(column - first_)]; }
  int axis() const { return axis_; }

 private:
  int axis_ = 0;
  std::array<int, 2> across_{1, 2};  ///< the axes other than axis_
  std::array<std::size_t, 3> strides_{};
  int first_ = 0;
  int firstVoxel_ = 0, endVoxel_ = 0;  ///< range of voxels along the axis that the columns use
  std::vector<Column> columns_;
};

}  // namespace insonate::views
