#include "AlignedColumns.h"

#include <cmath>

namespace insonate::views {
namespace {

/// A smaller deviation over a whole slice is rounding.
constexpr double kAligned_voxels = 1e-6;

bool isWithin(double index, int size) {
  return index >= -0.5 && index < size - 0.5;
}

int strongest(Vec3 v) {
  int axis = 0;
  for (int other = 1; other < 3; ++other)
    if (std::abs(v[other]) > std::abs(v[axis])) axis = other;
  return axis;
}

}  // namespace

bool AlignedColumns::place(const VolumeGeometry& grid, const SlicePlane& plane) {
  const Transform indexFromPatient = grid.indexFromPatient();
  const Vec3 step = indexFromPatient.linear * (plane.axes.right * plane.mm_per_px);
  const Vec3 rowStep = indexFromPatient.linear * (plane.axes.up * plane.mm_per_px);
  axis_ = strongest(step);
  across_ = {axis_ == 0 ? 1 : 0, axis_ == 2 ? 1 : 2};
  for (const int other : across_)
    if (std::abs(step[other]) * plane.width_px > kAligned_voxels) return false;
  if (std::abs(rowStep[axis_]) * plane.height_px > kAligned_voxels) return false;
  strides_ = {1, std::size_t(grid.size[0]), std::size_t(grid.size[0]) * grid.size[1]};
  const double start = (indexFromPatient * plane.patientFromDisplay({0.5, 0.5}))[axis_];
  const int size = grid.size[axis_];
  columns_.clear();
  first_ = 0;
  for (int column = 0; column < plane.width_px; ++column) {
    const double index = start + step[axis_] * column;
    if (!isWithin(index, size)) continue;
    if (columns_.empty()) first_ = column;
    const int nearest = static_cast<int>(index + 0.5);
    columns_.push_back({SliceCell(index, size), nearest, std::size_t(nearest) * strides_[std::size_t(axis_)]});
  }
  if (columns_.empty()) return true;
  const auto [least, most] = std::minmax(columns_.front().cell.low, columns_.back().cell.low);
  firstVoxel_ = least, endVoxel_ = std::min(most + 2, size);
  return true;
}

std::optional<AlignedColumns::Row> AlignedColumns::row(const VolumeGeometry& grid, const SlicePlane& plane,
                                                       int row) const {
  const Vec3 index = grid.indexFromPatient() * plane.patientFromDisplay({0.5, row + 0.5});
  std::array<int, 3> nearest{};
  for (const int axis : across_) {
    if (!isWithin(index[axis], grid.size[axis])) return std::nullopt;
    nearest[std::size_t(axis)] = static_cast<int>(index[axis] + 0.5);
  }
  const auto cell = [&](int axis) { return SliceCell(index[axis], grid.size[axis]); };
  return Row{{cell(across_[0]), cell(across_[1])}, nearest};
}

void AlignedColumns::mix(const CtVolume& ct, const Row& row, std::vector<float>& line) const {
  line.resize(std::size_t(ct.geometry.size[axis_]));
  const auto& [a, b] = row.across;
  const std::size_t strideA = strides_[std::size_t(across_[0])], strideB = strides_[std::size_t(across_[1])];
  const std::int16_t* lowLow = ct.voxels.data() + a.low * strideA + b.low * strideB;
  const std::int16_t* highLow = ct.voxels.data() + a.high * strideA + b.low * strideB;
  const std::int16_t* lowHigh = ct.voxels.data() + a.low * strideA + b.high * strideB;
  const std::int16_t* highHigh = ct.voxels.data() + a.high * strideA + b.high * strideB;
  const std::size_t along = strides_[std::size_t(axis_)];
  for (int voxel = firstVoxel_; voxel < endVoxel_; ++voxel) {
    const std::size_t at = std::size_t(voxel) * along;
    line[std::size_t(voxel)] =
        between(between(lowLow[at], highLow[at], a.share), between(lowHigh[at], highHigh[at], a.share), b.share);
  }
}

int AlignedColumns::hu(const std::vector<float>& line, int column) const {
  const SliceCell& cell = this->column(column).cell;
  const float mixed = between(line[std::size_t(cell.low)], line[std::size_t(cell.high)], cell.share);
  return static_cast<int>(std::floor(mixed + 0.5F));
}

}  // namespace insonate::views
