#include "Components.h"
#include "Guarded.h"

#include <insonate/segmentation/Brush.h>
#include <insonate/segmentation/RegionGrowing.h>
#include <insonate/segmentation/Threshold.h>

#include <array>
#include <cmath>

namespace insonate {
namespace {

using segmentation::Components;

/// Mean and standard deviation of the CT in a selection.
struct Statistics {
  double mean_HU = 0, sd_HU = 0;
  std::size_t voxels = 0;
};

class StatisticsSum {
 public:
  void add(const CtVolume& ct, const Selection& chosen) {
    const VoxelBox& box = chosen.box;
    for (int k = box.first[2]; k < box.end[2]; ++k)
      for (int j = box.first[1]; j < box.end[1]; ++j)
        for (int i = box.first[0]; i < box.end[0]; ++i) {
          if (!chosen.isSelected(i, j, k)) continue;
          const double hu = ct.at(i, j, k);
          sum_ += hu, squares_ += hu * hu, ++voxels_;
        }
  }
  Statistics result() const {
    if (voxels_ == 0) return {};
    const double mean = sum_ / double(voxels_);
    return {mean, std::sqrt(std::max(0.0, squares_ / double(voxels_) - mean * mean)), voxels_};
  }

 private:
  double sum_ = 0, squares_ = 0;
  std::size_t voxels_ = 0;
};

HuRange rangeOf(const Statistics& s, double deviations) {
  // A seed in homogeneous tissue, as in a phantom, has no deviation; rounding must not empty the range.
  const double half = std::max(deviations * s.sd_HU, 1.0);
  return {static_cast<int>(std::floor(s.mean_HU - half)), static_cast<int>(std::ceil(s.mean_HU + half))};
}

}  // namespace

Result<Selection> connected(const CtVolume& ct, const VoxelBox& box, std::span<const Vec3> seeds_mm, HuRange range,
                            const Progress& progress) {
  auto grown = segmentation::guarded([&] {
    Selection chosen(ct.geometry, box);
    if (box.empty()) return chosen;
    threshold(ct, range, chosen);
    segmentation::Work work(progress, 1);
    work.start("Growing");
    const Components pieces(chosen.mask, Components::Reach::Volume, work);
    const Transform indexFromPatient = chosen.mask.geometry.indexFromPatient();
    std::vector<bool> reached(pieces.count(), false);
    for (const Vec3& seed_mm : seeds_mm)
      if (const Vec3 index = indexFromPatient * seed_mm; sampleNearest(chosen.mask, index)) {
        const auto [i, j, k] = nearestVoxel(index);
        reached[pieces.componentAt(i, j, k)] = true;
      }
    std::ranges::fill(chosen.mask.voxels, std::uint8_t{0});
    pieces.paint(reached, 1, chosen.mask);
    return chosen;
  });
  if (grown && grown->count() == 0)
    return fail("No click in the region is on a voxel from " + std::to_string(range.low) + " to " +
                std::to_string(range.high) + " HU; click on such a voxel, or widen the range.");
  return grown;
}

Result<Selection> confidenceConnected(const CtVolume& ct, const VoxelBox& box, std::span<const Vec3> seeds_mm,
                                      const Confidence& confidence, const Progress& progress, HuRange* used) {
  StatisticsSum first;
  for (const Vec3& seed_mm : seeds_mm)
    first.add(ct, strokeVoxels(ct.geometry, std::array{seed_mm}, {.radius_mm = confidence.seed_mm}));
  Statistics statistics = first.result();
  if (statistics.voxels == 0) return fail("No click lies in the CT. Click on the structure.");
  for (int round = 0;; ++round) {
    const HuRange range = rangeOf(statistics, confidence.deviations);
    const Progress part = [&](std::string_view doing, double fraction) {
      return report(progress, doing, (round + fraction) / (confidence.rounds + 1));
    };
    auto grown = connected(ct, box, seeds_mm, range, part);
    if (used) *used = range;
    if (!grown || round == confidence.rounds) return grown;
    StatisticsSum sum;
    sum.add(ct, *grown);
    const Statistics next = sum.result();
    if (rangeOf(next, confidence.deviations) == range) return grown;
    statistics = next;
  }
}

}  // namespace insonate
