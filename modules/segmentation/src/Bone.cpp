#include "Bone.h"

#include "Blood.h"
#include "Components.h"

#include <insonate/tissue/Labels.h>

#include <algorithm>
#include <array>

namespace insonate::segmentation {
namespace {

// Threshold of the cores from which bone grows; higher if a contrast agent brightens blood.
constexpr int kDense_HU = 250, kDenseWithContrast_HU = 350;
constexpr int kBoneEdge_HU = 200;  // limit of growth: thin cortex of thick slices, trabeculae
constexpr double kGrow_mm = 4;     // maximum distance of growth, so that a touching vessel is not followed
// With contrast agent, a piece without cortex is a vessel too thin for findBrightBlood.
constexpr int kCortex_HU = 600;
constexpr double kCortexShare = 0.01;
constexpr double kSmallestPiece_mm3 = 60;
constexpr double kClose_mm = 1.5;
// The scanner's blur widens bone: its edge is where the CT falls to half of the value of the nearby bone.
constexpr double kBlur_mm = 1.2, kTissue_HU = 50;
// Marrow is a region that bone surrounds in a slice, if it is small or differs from spinal cord and brain (20-45 HU).
constexpr double kMarrow_mm2 = 60, kLargestMarrow_mm2 = 3000;
constexpr double kTrabecular_HU = 55, kFattyMarrow_HU = -15;

void removeVesselsAndSpecks(Mask& dense, const CtVolume& ct, bool contrast, Work& work) {
  const Components pieces(dense, Components::Reach::Volume, work);
  const auto sizes = pieces.sizes();
  std::vector<std::size_t> cortex(pieces.count(), 0);
  for (const auto& run : pieces.runs())
    for (int i = run.begin; i < run.end; ++i) cortex[run.component] += ct.at(i, run.j, run.k) > kCortex_HU;
  const auto& s = ct.geometry.spacing_mm;
  std::vector<bool> removed(pieces.count());
  for (std::size_t p = 0; p < removed.size(); ++p) {
    const auto size = static_cast<double>(sizes[p]);
    removed[p] = size * s.x * s.y * s.z < kSmallestPiece_mm3 ||
                 (contrast && static_cast<double>(cortex[p]) < kCortexShare * size);
  }
  pieces.paint(removed, 0, dense);
}

void fillMarrow(Mask& bone, const CtVolume& ct, const LabelMap& body, Work& work) {
  const auto& g = ct.geometry;
  Mask rest = bone;
  for (std::uint8_t& v : rest.voxels) v ^= 1;
  const Components holes(rest, Components::Reach::Slice, work);
  std::vector<bool> open(holes.count(), false);
  std::vector<double> sum_HU(holes.count(), 0);
  for (const auto& run : holes.runs()) {
    if (run.begin == 0 || run.end == g.size[0] || run.j == 0 || run.j + 1 == g.size[1]) open[run.component] = true;
    for (int i = run.begin; i < run.end; ++i) {
      sum_HU[run.component] += ct.at(i, run.j, run.k);
      if (body.at(i, run.j, run.k) != kSoftTissue) open[run.component] = true;
    }
  }
  const auto sizes = holes.sizes();
  std::vector<bool> marrow(holes.count());
  for (std::size_t h = 0; h < marrow.size(); ++h) {
    const double mean_HU = sum_HU[h] / static_cast<double>(sizes[h]);
    const double area_mm2 = static_cast<double>(sizes[h]) * g.spacing_mm.x * g.spacing_mm.y;
    marrow[h] = !open[h] && area_mm2 < kLargestMarrow_mm2 &&
                (area_mm2 < kMarrow_mm2 || mean_HU > kTrabecular_HU || mean_HU < kFattyMarrow_HU);
  }
  holes.paint(marrow, 1, bone);
}

/// Removes from the outermost voxels of bone those that are darker than halfway between tissue and the brightest voxel
/// nearby.
void takeBlur(Mask& bone, const CtVolume& ct, Work& work) {
  const auto& g = ct.geometry;
  std::array<int, 3> reach{};
  for (int axis = 0; axis < 3; ++axis) reach[axis] = static_cast<int>(kBlur_mm / g.spacing_mm[axis]);
  Mask inner = bone;
  erode(inner, kBlur_mm, work);
  const Mask whole = bone;
  work.slices(g.size[2], [&](int k) {
    for (int j = 0; j < g.size[1]; ++j)
      for (int i = 0; i < g.size[0]; ++i) {
        if (!whole.at(i, j, k) || inner.at(i, j, k)) continue;
        int brightest_HU = 0;
        for (int z = std::max(0, k - reach[2]); z <= std::min(g.size[2] - 1, k + reach[2]); ++z)
          for (int y = std::max(0, j - reach[1]); y <= std::min(g.size[1] - 1, j + reach[1]); ++y)
            for (int x = std::max(0, i - reach[0]); x <= std::min(g.size[0] - 1, i + reach[0]); ++x)
              brightest_HU = std::max<int>(brightest_HU, ct.at(x, y, z));
        if (ct.at(i, j, k) < (brightest_HU + kTissue_HU) / 2) bone.at(i, j, k) = 0;
      }
  });
}

}  // namespace

Mask findBone(const CtVolume& ct, const LabelMap& body, Work& work) {
  const BrightBlood blood = findBrightBlood(ct, body, work);
  const auto above = [&](std::size_t v, int threshold_HU) {
    return body.voxels[v] == kSoftTissue && !blood.mask.voxels[v] && ct.voxels[v] > threshold_HU;
  };
  Mask bone(ct.geometry);
  const int dense_HU = blood.present ? kDenseWithContrast_HU : kDense_HU;
  work.voxels(ct.geometry, [&](std::size_t v) { bone.voxels[v] = above(v, dense_HU); });
  removeVesselsAndSpecks(bone, ct, blood.present, work);
  dilate(bone, kGrow_mm, work);
  work.voxels(ct.geometry, [&](std::size_t v) { bone.voxels[v] &= std::uint8_t(above(v, kBoneEdge_HU)); });
  close(bone, kClose_mm, work);
  fillMarrow(bone, ct, body, work);
  takeBlur(bone, ct, work);
  work.voxels(ct.geometry, [&](std::size_t v) {
    bone.voxels[v] &= std::uint8_t(body.voxels[v] == kSoftTissue && !blood.mask.voxels[v]);
  });
  return bone;
}

}  // namespace insonate::segmentation
