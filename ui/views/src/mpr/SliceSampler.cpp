#include "SliceSampler.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace insonate::views {
namespace {

constexpr int kLowestHu = -32768;
constexpr std::uint8_t kNothing = 255;  ///< nothing is proposed
constexpr double kProposalFill = 0.5;

float trilinear(const CtVolume& ct, const SliceCell& i, const SliceCell& j, const SliceCell& k) {
  const auto& grid = ct.geometry;
  const std::int16_t* rows[4] = {
      ct.voxels.data() + grid.offset(0, j.low, k.low), ct.voxels.data() + grid.offset(0, j.high, k.low),
      ct.voxels.data() + grid.offset(0, j.low, k.high), ct.voxels.data() + grid.offset(0, j.high, k.high)};
  float along[4];
  for (int r = 0; r < 4; ++r) along[r] = between(rows[r][i.low], rows[r][i.high], i.share);
  return between(between(along[0], along[1], j.share), between(along[2], along[3], j.share), k.share);
}

void blend(std::uint8_t* rgb, Color color, double opacity) {
  const int weight = static_cast<int>(std::lround(256 * opacity));
  const int over[3] = {color.red, color.green, color.blue};
  for (int c = 0; c < 3; ++c) rgb[c] = static_cast<std::uint8_t>((rgb[c] * (256 - weight) + over[c] * weight) >> 8);
}

}  // namespace

void SliceSampler::setWindowLevel(const WindowLevel& value) {
  if (value == windowLevel_) return;
  windowLevel_ = value;
  grayOfHu_.resize(65536);
  for (int hu = kLowestHu; hu < -kLowestHu; ++hu) grayOfHu_[hu - kLowestHu] = value.gray(hu);
}

std::uint8_t SliceSampler::proposedAt(int i, int j, int k) const {
  if (!proposalBox_.contains(i, j, k)) return kNothing;
  return proposal_->at(i - proposalBox_.first[0], j - proposalBox_.first[1], k - proposalBox_.first[2]);
}

void SliceSampler::sampleAlignedRow(const CtVolume& ct, const LabelMap& labels, const SlicePlane& plane, int row,
                                    std::uint8_t* rgb) {
  thread_local std::vector<float> line;
  std::uint8_t* label = rowLabels_.data() + std::size_t(row) * plane.width_px;
  std::uint8_t* proposed = proposal_ ? rowProposed_.data() + std::size_t(row) * plane.width_px : nullptr;
  std::fill_n(rgb, 3 * std::size_t(plane.width_px), std::uint8_t{0});
  std::fill_n(label, plane.width_px, std::uint8_t{0});
  if (proposal_) std::fill_n(proposed, plane.width_px, kNothing);
  const auto across = columns_.row(ct.geometry, plane, row);
  if (!across) return;
  columns_.mix(ct, *across, line);
  const auto [i, j, k] = across->nearest;
  const std::uint8_t* labeled = labels.voxels.data() + labels.geometry.offset(i, j, k);
  for (int column = columns_.first(); column < columns_.end(); ++column) {
    std::uint8_t* pixel = rgb + 3 * std::size_t(column);
    pixel[0] = pixel[1] = pixel[2] = grayOfHu_[columns_.hu(line, column) - kLowestHu];
    label[column] = labeled[columns_.column(column).offset];
  }
  if (!proposal_) return;
  std::array<int, 3> at = across->nearest;
  for (int column = columns_.first(); column < columns_.end(); ++column) {
    at[std::size_t(columns_.axis())] = columns_.column(column).nearest;
    proposed[column] = proposedAt(at[0], at[1], at[2]);
  }
}

void SliceSampler::sampleObliqueRow(const CtVolume& ct, const LabelMap& labels, const SlicePlane& plane, int row,
                                    std::uint8_t* rgb) {
  const VolumeGeometry& grid = ct.geometry;
  const Transform indexFromPatient = grid.indexFromPatient();
  const Vec3 first = indexFromPatient * plane.patientFromDisplay({0.5, row + 0.5});
  const Vec3 step = indexFromPatient.linear * (plane.axes.right * plane.mm_per_px);
  std::uint8_t* label = rowLabels_.data() + std::size_t(row) * plane.width_px;
  std::uint8_t* proposed = proposal_ ? rowProposed_.data() + std::size_t(row) * plane.width_px : nullptr;
  for (int column = 0; column < plane.width_px; ++column, rgb += 3) {
    const Vec3 index = first + step * column;
    bool inside = true;
    for (int axis = 0; axis < 3; ++axis) inside &= index[axis] >= -0.5 && index[axis] < grid.size[axis] - 0.5;
    if (!inside) {
      rgb[0] = rgb[1] = rgb[2] = 0;
      label[column] = 0;
      if (proposal_) proposed[column] = kNothing;
      continue;
    }
    const SliceCell i(index.x, grid.size[0]), j(index.y, grid.size[1]), k(index.z, grid.size[2]);
    const auto hu = static_cast<int>(std::floor(trilinear(ct, i, j, k) + 0.5F));
    rgb[0] = rgb[1] = rgb[2] = grayOfHu_[hu - kLowestHu];
    const auto ni = static_cast<int>(index.x + 0.5), nj = static_cast<int>(index.y + 0.5),
               nk = static_cast<int>(index.z + 0.5);
    label[column] = labels.at(ni, nj, nk);
    if (proposal_) proposed[column] = proposedAt(ni, nj, nk);
  }
}

bool SliceSampler::isEdge(const SlicePlane& plane, int row, int column) const {
  const std::uint8_t* label = rowLabels_.data() + std::size_t(row) * plane.width_px + column;
  const auto differs = [&](int across, int down) {
    const bool seen =
        column + across >= 0 && column + across < plane.width_px && row + down >= 0 && row + down < plane.height_px;
    return seen && label[std::ptrdiff_t(down) * plane.width_px + across] != *label;
  };
  // Comparing with one neighbor makes the line one pixel wide; each further pixel is added on alternating sides.
  for (int n = 0; n < outline_px_; ++n) {
    const int away = n % 2 == 0 ? n / 2 + 1 : -(n / 2 + 1);
    if (differs(away, 0) || differs(0, away)) return true;
  }
  return false;
}

void SliceSampler::paintRow(const SlicePlane& plane, int row, std::uint8_t* rgb) const {
  const std::uint8_t* label = rowLabels_.data() + std::size_t(row) * plane.width_px;
  const std::uint8_t* below = row + 1 < plane.height_px ? label + plane.width_px : label;
  const std::uint8_t* proposed = proposal_ ? rowProposed_.data() + (label - rowLabels_.data()) : nullptr;
  const std::uint8_t* proposedBelow = proposal_ ? proposed + (below - label) : nullptr;
  for (int column = 0; column < plane.width_px; ++column, rgb += 3) {
    const std::uint8_t own = label[column];
    if (proposal_ && proposed[column] != kNothing) {
      const bool rim = proposed[std::min(plane.width_px - 1, column + 1)] != proposed[column] ||
                       proposedBelow[column] != proposed[column];
      blend(rgb, paint_[proposed[column]].color, rim ? 1 : kProposalFill);
      continue;
    }
    const LabelPaint& paint = paint_[own];
    if (paint.fill <= 0 && paint.outline <= 0) continue;
    blend(rgb, paint.color, isEdge(plane, row, column) ? std::max(paint.fill, paint.outline) : paint.fill);
  }
}

SliceSampler::Rows SliceSampler::rowsOf(const VolumeGeometry& grid, const VoxelBox& edited,
                                        const SlicePlane& plane) const {
  double top = plane.height_px, bottom = 0;
  for (int corner = 0; corner < 8; ++corner) {
    Vec3 index;
    for (int axis = 0; axis < 3; ++axis) index[axis] = (corner >> axis & 1 ? edited.end : edited.first)[axis] - 0.5;
    const double y = plane.displayFromPatient(grid.patientFromIndex() * index).y;
    top = std::min(top, y), bottom = std::max(bottom, y);
  }
  const int rim = outline_px_ + 1;
  return {std::max(0, static_cast<int>(std::floor(top)) - rim),
          std::min(plane.height_px, static_cast<int>(std::ceil(bottom)) + rim)};
}

void SliceSampler::sample(const CtVolume& ct, const LabelMap& labels, const SlicePlane& plane, Rows wanted,
                          std::span<std::uint8_t> rgb) {
  if (wanted.first >= wanted.end) return;
  const std::size_t stride = std::size_t(plane.width_px) * 3;
  rowLabels_.resize(std::size_t(plane.width_px) * plane.height_px);
  if (proposal_) rowProposed_.resize(rowLabels_.size());
  const auto sampleRow =
      columns_.place(ct.geometry, plane) ? &SliceSampler::sampleAlignedRow : &SliceSampler::sampleObliqueRow;
  const tbb::blocked_range<int> rows(wanted.first, wanted.end, 16);
  tbb::parallel_for(rows, [&](const auto& range) {
    for (int row = range.begin(); row < range.end(); ++row)
      (this->*sampleRow)(ct, labels, plane, row, rgb.data() + row * stride);
  });
  // Outlines need the rows above and below.
  tbb::parallel_for(rows, [&](const auto& range) {
    for (int row = range.begin(); row < range.end(); ++row) paintRow(plane, row, rgb.data() + row * stride);
  });
}

}  // namespace insonate::views
