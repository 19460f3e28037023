#include <insonate/segmentation/Region.h>

#include <algorithm>
#include <numeric>

namespace insonate {

Selection::Selection(const VolumeGeometry& geometry, const VoxelBox& where) : box(where) {
  if (!box.empty()) mask = Volume<std::uint8_t>(gridOf(geometry, box));
}

std::size_t Selection::count() const {
  return std::accumulate(mask.voxels.begin(), mask.voxels.end(), std::size_t{0});
}

Selection voxelsOf(const LabelMap& labels, std::uint8_t label, const VoxelBox& where) {
  Selection chosen;
  chosen.box = where;
  if (where.empty()) return chosen;
  chosen.mask = cropped(labels, where);
  for (std::uint8_t& voxel : chosen.mask.voxels) voxel = voxel == label;
  return chosen;
}

VoxelBox boundingBoxOf(const LabelMap& labels, std::uint8_t label) {
  const auto [ni, nj, nk] = labels.geometry.size;
  VoxelBox extent{{ni, nj, nk}, {0, 0, 0}};
  for (int k = 0; k < nk; ++k)
    for (int j = 0; j < nj; ++j) {
      const std::uint8_t* const row = &labels.at(0, j, k);
      const std::uint8_t* const found = std::find(row, row + ni, label);
      if (found == row + ni) continue;
      int last = ni - 1;
      while (row[last] != label) --last;
      extent.first = {std::min(extent.first[0], static_cast<int>(found - row)), std::min(extent.first[1], j),
                      std::min(extent.first[2], k)};
      extent.end = {std::max(extent.end[0], last + 1), std::max(extent.end[1], j + 1), k + 1};
    }
  return extent.empty() ? VoxelBox{} : extent;
}

Proposal proposePainting(Selection chosen, std::uint8_t label) {
  for (std::uint8_t& voxel : chosen.mask.voxels) voxel = voxel ? label : Proposal::kKeep;
  return {chosen.box, std::move(chosen.mask)};
}

Proposal proposeShape(Selection shape, const LabelMap& labels, std::uint8_t label, std::uint8_t rest) {
  const VoxelBox& box = shape.box;
  std::uint8_t* voxel = shape.mask.voxels.data();
  for (int k = box.first[2]; k < box.end[2]; ++k)
    for (int j = box.first[1]; j < box.end[1]; ++j)
      for (int i = box.first[0]; i < box.end[0]; ++i, ++voxel) {
        const bool had = labels.at(i, j, k) == label;
        *voxel = *voxel ? label : had ? rest : Proposal::kKeep;
      }
  return {box, std::move(shape.mask)};
}

}  // namespace insonate
