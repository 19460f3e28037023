#include "Blocks.h"

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

/// The row of voxels along i, as a pair of pointers.
std::pair<const std::uint8_t*, const std::uint8_t*> rowOf(const LabelMap& labels, int first, int last, int j, int k) {
  const std::uint8_t* row = labels.voxels.data() + labels.geometry.offset(0, j, k);
  return {row + first, row + last + 1};
}

}  // namespace

std::optional<LabelBox> boxOf(const LabelMap& labels, const LabelSet& structure) {
  const auto belongs = [&](std::uint8_t label) { return structure[label]; };
  const auto& size = labels.geometry.size;
  LabelBox box{size, {-1, -1, -1}};
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j) {
      const auto [begin, end] = rowOf(labels, 0, size[0] - 1, j, k);
      const auto* found = std::find_if(begin, end, belongs);
      if (found == end) continue;
      const auto* last = std::find_if(std::reverse_iterator(end), std::reverse_iterator(found), belongs).base() - 1;
      const std::array<int, 3> low{static_cast<int>(found - begin), j, k}, high{static_cast<int>(last - begin), j, k};
      for (int a = 0; a < 3; ++a) {
        box.first[a] = std::min(box.first[a], low[a]);
        box.last[a] = std::max(box.last[a], high[a]);
      }
      box.voxels += std::count_if(found, last + 1, belongs);
    }
  if (box.voxels == 0) return std::nullopt;
  return box;
}

std::array<int, 3> blockSize(const VolumeGeometry& geometry, double edge_mm) {
  std::array<int, 3> result{};
  // A small margin, so that 1 mm is two voxels of 0.5 mm in spite of rounding.
  for (int a = 0; a < 3; ++a) result[a] = std::max(1, static_cast<int>(edge_mm / geometry.spacing_mm[a] * 1.0001));
  return result;
}

Volume<std::uint8_t> structureShare(const LabelMap& labels, const LabelSet& structure, const LabelBox& box,
                                    const std::array<int, 3>& voxelsPerBlock) {
  const auto& n = voxelsPerBlock;
  VolumeGeometry grid = labels.geometry;
  Vec3 firstCenter;
  for (int a = 0; a < 3; ++a) {
    grid.size[a] = (box.last[a] - box.first[a]) / n[a] + 1 + 2;
    grid.spacing_mm[a] *= n[a];
    firstCenter[a] = box.first[a] - n[a] + (n[a] - 1) / 2.0;
  }
  grid.origin_mm = labels.geometry.patientFromIndex() * firstCenter;

  Volume<std::uint8_t> share(grid);
  const double full = double(n[0]) * n[1] * n[2];
  std::vector<std::uint32_t> counts(std::size_t(grid.size[0]) * grid.size[1]);
  for (int layer = 1; layer < grid.size[2] - 1; ++layer) {
    std::ranges::fill(counts, 0U);
    const int k0 = box.first[2] + (layer - 1) * n[2];
    for (int k = k0; k < k0 + n[2] && k <= box.last[2]; ++k)
      for (int j = box.first[1]; j <= box.last[1]; ++j) {
        std::uint32_t* count = counts.data() + std::size_t((j - box.first[1]) / n[1] + 1) * grid.size[0] + 1;
        const auto [begin, end] = rowOf(labels, box.first[0], box.last[0], j, k);
        for (auto* voxel = begin; voxel != end; ++count)
          for (int i = 0; i < n[0] && voxel != end; ++i) *count += structure[*voxel++];
      }
    std::uint8_t* out = &share.at(0, 0, layer);
    for (const std::uint32_t count : counts) *out++ = static_cast<std::uint8_t>(std::lround(255 * count / full));
  }
  return share;
}

}  // namespace insonate
