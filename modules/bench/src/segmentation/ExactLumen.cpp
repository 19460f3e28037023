#include "ExactLumen.h"

#include <insonate/segmentation/Margin.h>

#include <algorithm>

namespace insonate::bench {
namespace {

constexpr int kParts = 3;  // parts of a voxel along each axis
constexpr std::int16_t kMuscle_HU = 50;

std::int16_t medianIn(const CtVolume& ct, const Selection& mask) {
  std::vector<std::int16_t> hu;
  const VoxelBox& box = mask.box;
  for (int k = box.first[2]; k < box.end[2]; ++k)
    for (int j = box.first[1]; j < box.end[1]; ++j)
      for (int i = box.first[0]; i < box.end[0]; ++i)
        if (mask.isSelected(i, j, k)) hu.push_back(ct.at(i, j, k));
  const auto middle = hu.begin() + std::ptrdiff_t(hu.size() / 2);
  std::ranges::nth_element(hu, middle);
  return *middle;
}

/// Parts of the voxels of `where` that are brighter than halfway between muscle and blood; metal counts as blood, fat
/// and air as muscle.
Selection brightParts(const CtVolume& ct, const Selection& where, std::int16_t blood_HU) {
  CtVolume hu = cropped(ct, where.box);
  for (std::int16_t& v : hu.voxels) v = std::clamp(v, std::min(kMuscle_HU, blood_HU), std::max(kMuscle_HU, blood_HU));
  VolumeGeometry fine = hu.geometry;
  fine.spacing_mm = fine.spacing_mm / kParts;
  for (int& length : fine.size) length *= kParts;
  Selection bright(fine, boxOf(fine));
  const double half_HU = (blood_HU + kMuscle_HU) / 2.0;
  const auto in = [](int part) { return (part + 0.5) / kParts - 0.5; };
  for (int k = 0; k < fine.size[2]; ++k)
    for (int j = 0; j < fine.size[1]; ++j)
      for (int i = 0; i < fine.size[0]; ++i)
        if (where.mask.at(i / kParts, j / kParts, k / kParts))
          bright.mask.at(i, j, k) = sampleLinear(hu, {in(i), in(j), in(k)}) > half_HU;
  return bright;
}

/// Voxels of `where` with more than half of their parts chosen.
Selection mostly(const Selection& parts, const Selection& where) {
  Selection voxels = where;
  const auto& size = where.mask.geometry.size;
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i) {
        int chosen = 0;
        for (int n = 0; n < kParts * kParts * kParts; ++n)
          chosen += parts.mask.at(kParts * i + n % kParts, kParts * j + n / kParts % kParts,
                                  kParts * k + n / (kParts * kParts));
        voxels.mask.at(i, j, k) &= std::uint8_t(2 * chosen > kParts * kParts * kParts);
      }
  return voxels;
}

double dice(const Selection& mask, const Selection& found) {
  std::size_t both = 0;
  const VoxelBox& box = mask.box;
  for (int k = box.first[2]; k < box.end[2]; ++k)
    for (int j = box.first[1]; j < box.end[1]; ++j)
      for (int i = box.first[0]; i < box.end[0]; ++i) both += mask.isSelected(i, j, k) && found.isSelected(i, j, k);
  return 2 * double(both) / double(mask.count() + found.count());
}

}  // namespace

Result<WallScores> scoreExactLumen(const CtVolume& ct, const Selection& mask, const Selection& where,
                                   const Progress& progress) {
  const Selection lumen = brightParts(ct, where, medianIn(ct, mask));
  WallScores scores{};
  for (std::size_t n = 0; n < kWalls_mm.size(); ++n) {
    const auto walled = grownBy(lumen, kWalls_mm[n], progress);
    if (!walled) return tl::unexpected(walled.error());
    scores[n] = dice(mask, mostly(*walled, where));
  }
  return scores;
}

}  // namespace insonate::bench
