#include "Components.h"
#include "Guarded.h"

#include <insonate/segmentation/Islands.h>

#include <algorithm>
#include <numeric>

namespace insonate {
namespace {

using segmentation::Components;
using segmentation::guarded;
using segmentation::Work;

constexpr std::string_view kDoing = "Finding islands";

Components islandsOf(const Selection& selection, Work& work) {
  work.start(kDoing);
  return Components(selection.mask, Components::Reach::Volume, work);
}

/// Islands by decreasing size; equal ones in their order of occurrence.
std::vector<std::uint32_t> bySize(const std::vector<std::size_t>& sizes) {
  std::vector<std::uint32_t> order(sizes.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, [&](std::uint32_t a, std::uint32_t b) { return sizes[a] > sizes[b]; });
  return order;
}

/// The selection with the islands that `chosen(islands)` marks.
template <class Choose>
Result<Selection> keep(const Selection& of, const Progress& progress, const Choose& choose) {
  if (of.box.empty()) return of;
  return guarded([&] {
    Work work(progress, 1);
    const Components islands = islandsOf(of, work);
    Selection kept = of;
    std::ranges::fill(kept.mask.voxels, std::uint8_t{0});
    islands.paint(choose(islands), 1, kept.mask);
    return kept;
  });
}

}  // namespace

Result<Selection> largestIslands(const Selection& of, int count, const Progress& progress) {
  return keep(of, progress, [&](const Components& islands) {
    std::vector<bool> chosen(islands.count(), false);
    const auto order = bySize(islands.sizes());
    for (std::size_t n = 0; n < std::min(order.size(), std::size_t(std::max(count, 0))); ++n) chosen[order[n]] = true;
    return chosen;
  });
}

Result<Selection> islandsOfMinimumVolume(const Selection& of, double min_mm3, const Progress& progress) {
  return keep(of, progress, [&](const Components& islands) {
    const Vec3& s = of.mask.geometry.spacing_mm;
    std::vector<bool> chosen;
    for (const std::size_t voxels : islands.sizes())
      chosen.push_back(static_cast<double>(voxels) * s.x * s.y * s.z >= min_mm3);
    return chosen;
  });
}

Result<Selection> islandAt(const Selection& of, Vec3 point_mm, const Progress& progress) {
  const Vec3 index = of.box.empty() ? Vec3{-9, -9, -9} : of.mask.geometry.indexFromPatient() * point_mm;
  if (of.box.empty() || sampleNearest(of.mask, index) == 0)
    return fail("No island of the label is at this point. Click on an island.");
  const auto voxel = nearestVoxel(index);
  return keep(of, progress, [&](const Components& islands) {
    std::vector<bool> chosen(islands.count(), false);
    chosen[islands.componentAt(voxel[0], voxel[1], voxel[2])] = true;
    return chosen;
  });
}

Result<Proposal> splitIslands(const Selection& of, std::span<const std::uint8_t> labels, const Progress& progress) {
  if (of.box.empty()) return Proposal{};
  return guarded([&] {
    Work work(progress, 1);
    const Components islands = islandsOf(of, work);
    Proposal proposal{of.box, Volume<std::uint8_t>(of.mask.geometry, Proposal::kKeep)};
    const auto order = bySize(islands.sizes());
    for (std::size_t n = 0; n < std::min(order.size(), labels.size()); ++n) {
      std::vector<bool> one(islands.count(), false);
      one[order[n]] = true;
      islands.paint(one, labels[n], proposal.labels);
    }
    return proposal;
  });
}

}  // namespace insonate
