#include "SegmentationParts.h"
#include "VesselScore.h"

#include <insonate/cases/Import.h>
#include <insonate/cases/LabelFile.h>
#include <insonate/segmentation/Margin.h>

#include <algorithm>

namespace insonate::bench {
namespace {

constexpr double kVesselBar = 0.90;
constexpr double kShortest_mm = 15;

struct Mask {
  const char *file, *name;
  double largest_mm;  ///< as an author sets it: more than half of the vessel's width
};
constexpr Mask kMasks[]{{"common_carotid_artery_left.nii.gz", "left common carotid", 12},
                        {"subclavian_artery_left.nii.gz", "left subclavian", 12},
                        {"brachiocephalic_trunk.nii.gz", "brachiocephalic trunk", 12},
                        {"aorta_true_lumen.nii.gz", "aorta, true lumen", 25}};

/// The best Dice of any threshold near the mask.
Result<double> reachable(const CtVolume& ct, const Selection& mask, const Progress& progress) {
  const Vec3& s = ct.geometry.spacing_mm;
  const double reach_mm = 2 * std::max({s.x, s.y, s.z});
  const VoxelBox box = grown(mask.box, ct.geometry, reach_mm);
  Selection wide(ct.geometry, box);
  for (int k = 0; k < box.length(2); ++k)
    for (int j = 0; j < box.length(1); ++j)
      for (int i = 0; i < box.length(0); ++i)
        wide.mask.at(i, j, k) = mask.chosen(box.first[0] + i, box.first[1] + j, box.first[2] + k);
  const auto near = grownBy(wide, reach_mm, progress);
  if (!near) return tl::unexpected(near.error());
  const CtVolume hu = cropped(ct, box);
  const double inMask = double(wide.count());
  double best = 0;
  for (int threshold_HU = 50; threshold_HU <= 500; threshold_HU += 10) {
    std::size_t found = 0, both = 0;
    for (std::size_t v = 0; v < hu.voxels.size(); ++v) {
      const bool chosen = near->mask.voxels[v] && hu.voxels[v] > threshold_HU;
      found += chosen, both += chosen && wide.mask.voxels[v];
    }
    best = std::max(best, 2 * double(both) / (double(found) + inMask));
  }
  return best;
}

/// The mask's Dice with itself, on voxels of half the size, of which the outermost layer is missing.
Result<double> halfVoxelOff(const Selection& mask, const Progress& progress) {
  VolumeGeometry fine = mask.mask.geometry;
  fine.spacing_mm = fine.spacing_mm * 0.5;
  for (int& length : fine.size) length = 2 * length + 2;  // and a margin
  Selection whole(fine, boxOf(fine));
  for (int k = 1; k + 1 < fine.size[2]; ++k)
    for (int j = 1; j + 1 < fine.size[1]; ++j)
      for (int i = 1; i + 1 < fine.size[0]; ++i)
        whole.mask.at(i, j, k) = mask.mask.at((i - 1) / 2, (j - 1) / 2, (k - 1) / 2);
  const Vec3& s = fine.spacing_mm;
  const auto inner = shrunkBy(whole, std::max({s.x, s.y, s.z}), progress);
  if (!inner) return tl::unexpected(inner.error());
  return 2 * double(inner->count()) / double(inner->count() + whole.count());
}

/// Where a mask is too stout for a centre line, the middles of its axial slices.
TrueVessel stoutVessel(const LabelMap& labels) {
  TrueVessel vessel{{}, voxelsOf(labels, 1, extentOf(labels, 1)), {}};
  const VoxelBox& box = vessel.voxels.box;
  const Transform patientFromIndex = labels.geometry.patientFromIndex();
  for (int k = box.first[2]; k < box.end[2]; ++k) {
    Vec3 sum;
    double count = 0;
    for (int j = box.first[1]; j < box.end[1]; ++j)
      for (int i = box.first[0]; i < box.end[0]; ++i)
        if (vessel.voxels.chosen(i, j, k)) sum = sum + Vec3{double(i), double(j), double(k)}, ++count;
    if (count > 0) vessel.line.push_back(patientFromIndex * (sum / count));
  }
  return vessel;
}

Result<void> scoreMask(const CtVolume& ct, const std::filesystem::path& folder, const Mask& mask, ScoreRows& rows,
                       const Progress& progress) {
  auto read = readLabelMap(folder / mask.file);
  if (!read) return tl::unexpected(read.error());
  LabelMap& labels = read->labels;
  if (!sameGrid(labels.geometry, ct.geometry))
    return fail(std::string(mask.file) + " is on another grid than the CT beside it.");
  if (extentOf(labels, 1).empty()) return fail("There is no vessel in " + (folder / mask.file).string() + ".");
  const auto vessels = trueVessels(labels, 1, 1, kShortest_mm, progress);
  if (!vessels) return tl::unexpected(vessels.error());
  const TrueVessel vessel = vessels->empty() ? stoutVessel(labels) : vessels->front();
  const auto best = reachable(ct, betweenEnds(vessel.voxels, vessel.line), progress);
  if (!best) return tl::unexpected(best.error());
  const auto halfOff = halfVoxelOff(betweenEnds(vessel.voxels, vessel.line), progress);
  if (!halfOff) return tl::unexpected(halfOff.error());
  for (const int clicks : {2, 4}) {
    SegmentationScoreRow row;
    row.variant = "chest CTA", row.contrast = "arterial", row.structure = mask.name;
    row.reachable = *best, row.halfVoxelOff = *halfOff;
    if (clicks == 4) row.bar = kVesselBar;
    auto scored = scoreClicks(ct, vessel, clicks, {.largest_mm = mask.largest_mm}, row, progress);
    if (!scored) return tl::unexpected(scored.error());
    rows.push_back(std::move(*scored));
  }
  return {};
}

}  // namespace

Result<ScoreRows> scoreChestCta(const std::filesystem::path& folder, const Progress& progress) {
  const auto imported = importSeries(folder / "ct_cropped.nii.gz", {}, progress);
  if (!imported) return tl::unexpected(imported.error());
  ScoreRows rows;
  for (const Mask& mask : kMasks)
    if (auto ok = scoreMask(imported->ct, folder, mask, rows, progress); !ok) return tl::unexpected(ok.error());
  return rows;
}

}  // namespace insonate::bench
