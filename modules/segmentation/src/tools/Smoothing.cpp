#include "Guarded.h"
#include "Morphology.h"

#include <insonate/image/GaussianBlur.h>
#include <insonate/segmentation/Smoothing.h>
#include <insonate/tissue/Labels.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace insonate::segmentation {
namespace {

using Counts = Volume<std::uint32_t>;

/// Replaces a line of numbers, `stride` apart, by their sums over `reach` to both sides.
void sumAlong(std::uint32_t* line, std::size_t stride, int count, int reach, std::vector<std::uint32_t>& sums) {
  sums.resize(count + 1);
  sums[0] = 0;
  for (int n = 0; n < count; ++n) sums[n + 1] = sums[n] + line[n * stride];
  for (int n = 0; n < count; ++n)
    line[n * stride] = sums[std::min(count, n + reach + 1)] - sums[std::max(0, n - reach)];
}

/// Sets each voxel to the majority of the voxels within `radius_mm` along every axis; at the grid's edge, of those
/// that exist.
void majorityInBlock(Mask& mask, double radius_mm, Work& work) {
  const VolumeGeometry& g = mask.geometry;
  const auto [ni, nj, nk] = g.size;
  std::array<int, 3> reach{};
  for (int axis = 0; axis < 3; ++axis)
    reach[axis] = static_cast<int>(std::min(radius_mm / g.spacing_mm[axis], double(g.size[axis])));
  Counts counts(g);
  work.slices(nk, [&, ni = ni, nj = nj](int k) {
    std::vector<std::uint32_t> sums;
    std::copy_n(&mask.at(0, 0, k), std::size_t(ni) * nj, &counts.at(0, 0, k));
    for (int j = 0; j < nj; ++j) sumAlong(&counts.at(0, j, k), 1, ni, reach[0], sums);
    for (int i = 0; i < ni; ++i) sumAlong(&counts.at(i, 0, k), ni, nj, reach[1], sums);
  });
  work.slices(nj, [&, ni = ni, nj = nj, nk = nk](int j) {
    std::vector<std::uint32_t> sums;
    for (int i = 0; i < ni; ++i) sumAlong(&counts.at(i, j, 0), std::size_t(ni) * nj, nk, reach[2], sums);
  });
  const auto width = [&](int axis, int at) {
    return std::uint32_t(std::min(g.size[axis], at + reach[axis] + 1) - std::max(0, at - reach[axis]));
  };
  work.slices(nk, [&, ni = ni, nj = nj](int k) {
    for (int j = 0; j < nj; ++j) {
      const std::uint32_t rows = width(1, j) * width(2, k);
      for (int i = 0; i < ni; ++i) mask.at(i, j, k) = 2 * counts.at(i, j, k) > rows * width(0, i);
    }
  });
}

}  // namespace
}  // namespace insonate::segmentation

namespace insonate {
namespace {

using segmentation::guarded;
using segmentation::Work;

Error vanished(const std::string& what) {
  return {what + " would vanish, since it is thinner than the smoothing radius. Use a smaller radius."};
}

/// Applies `change(mask, work)` in place.
template <class Change>
Result<Selection> changed(const Selection& shape, double passes, const Progress& progress, const Change& change) {
  if (shape.box.empty()) return shape;
  auto result = guarded([&] {
    Work work(progress, passes);
    work.start("Smoothing");
    Selection smooth = shape;
    change(smooth.mask, work);
    return smooth;
  });
  if (result && result->count() == 0 && shape.count() > 0) return tl::unexpected(vanished("The shape"));
  return result;
}

Volume<float> shareOf(const Volume<std::uint8_t>& labels, std::uint8_t label) {
  Volume<float> share(labels.geometry);
  std::ranges::transform(labels.voxels, share.voxels.begin(),
                         [=](std::uint8_t voxel) { return voxel == label ? 1.F : 0.F; });
  return share;
}

}  // namespace

Result<Selection> medianSmoothed(const Selection& shape, double radius_mm, const Progress& progress) {
  return changed(shape, 4, progress,
                 [&](segmentation::Mask& mask, Work& work) { segmentation::majorityInBlock(mask, radius_mm, work); });
}

Result<Selection> opened(const Selection& shape, double radius_mm, const Progress& progress) {
  return changed(shape, 6, progress,
                 [&](segmentation::Mask& mask, Work& work) { segmentation::open(mask, radius_mm, work); });
}

Result<Selection> closed(const Selection& shape, double radius_mm, const Progress& progress) {
  return changed(shape, 6, progress,
                 [&](segmentation::Mask& mask, Work& work) { segmentation::close(mask, radius_mm, work); });
}

Result<Selection> gaussianSmoothed(const Selection& shape, double sigma_mm, const Progress& progress) {
  return changed(shape, 3, progress, [&](segmentation::Mask& mask, Work& work) {
    Volume<float> share = shareOf(mask, 1);
    work.checkpoint(1);
    blurGaussian(share, sigma_mm);
    work.voxels(mask.geometry, [&](std::size_t v) { mask.voxels[v] = share.voxels[v] >= 0.5F; });
  });
}

Result<Proposal> jointlySmoothed(const LabelMap& labels, const VoxelBox& box, const LabelSet& which, double sigma_mm,
                                 const Progress& progress) {
  if (box.empty()) return Proposal{};
  LabelSet before, after;
  auto result = guarded([&] {
    const LabelMap part = cropped(labels, box);
    for (const std::uint8_t label : part.voxels) before.set(label);
    before &= which;
    Work work(progress, 2.0 * static_cast<double>(before.count()) + 1);
    work.start("Smoothing labels together");
    Proposal proposal{box, Volume<std::uint8_t>(part.geometry, Proposal::kKeep)};
    Volume<float> largest(part.geometry);
    for (std::size_t label = before._Find_first(); label < before.size(); label = before._Find_next(label)) {
      Volume<float> share = shareOf(part, static_cast<std::uint8_t>(label));
      blurGaussian(share, sigma_mm);
      work.voxels(part.geometry, [&](std::size_t v) {
        if (!which.test(part.voxels[v]) || share.voxels[v] <= largest.voxels[v]) return;
        largest.voxels[v] = share.voxels[v];
        proposal.labels.voxels[v] = static_cast<std::uint8_t>(label);
      });
    }
    for (const std::uint8_t label : proposal.labels.voxels) after.set(label);
    return proposal;
  });
  if (const LabelSet lost = before & ~after; result && lost.any())
    return tl::unexpected(vanished("The label " + labelName(static_cast<std::uint8_t>(lost._Find_first()))));
  return result;
}

}  // namespace insonate
