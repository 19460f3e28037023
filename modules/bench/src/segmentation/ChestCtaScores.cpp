#include "ExactLumen.h"
#include "SegmentationParts.h"
#include "VesselScore.h"

#include <insonate/cases/Import.h>
#include <insonate/cases/LabelFile.h>
#include <insonate/segmentation/Margin.h>

#include <algorithm>

namespace insonate::bench {
namespace {

constexpr double kChestVesselBar = 0.90;
constexpr double kShortestVessel_mm = 15;

struct Mask {
  const char *file, *name;
  double largest_mm;  ///< the author's setting: more than half of the vessel's width
};
constexpr Mask kMasks[]{{"common_carotid_artery_left.nii.gz", "left common carotid", 12},
                        {"subclavian_artery_left.nii.gz", "left subclavian", 12},
                        {"brachiocephalic_trunk.nii.gz", "brachiocephalic trunk", 12},
                        {"aorta_true_lumen.nii.gz", "aorta, true lumen", 25}};

/// Accepts voxels within two voxels of the vessel, between its ends, and in no other vessel.
Result<Selection> around(const CtVolume& ct, const TrueVessel& vessel, const std::vector<LabelMap>& others,
                         const Progress& progress) {
  const Vec3& s = ct.geometry.spacing_mm;
  const double reach_mm = 2 * std::max({s.x, s.y, s.z});
  const VoxelBox box = grown(vessel.voxels.box, ct.geometry, reach_mm);
  Selection wide(ct.geometry, box);
  for (int k = 0; k < box.length(2); ++k)
    for (int j = 0; j < box.length(1); ++j)
      for (int i = 0; i < box.length(0); ++i)
        wide.mask.at(i, j, k) = vessel.voxels.isSelected(box.first[0] + i, box.first[1] + j, box.first[2] + k);
  auto near = grownBy(wide, reach_mm, progress);
  if (!near) return near;
  for (const LabelMap& other : others) near = without(std::move(*near), voxelsOf(other, 1, box));
  return betweenEnds(without(std::move(*near), vessel.others), vessel.line);
}

/// Centers of the axial slices, for a mask that is too wide for a center line.
TrueVessel stoutVessel(const LabelMap& labels) {
  TrueVessel vessel{{}, voxelsOf(labels, 1, boundingBoxOf(labels, 1)), {}};
  const VoxelBox& box = vessel.voxels.box;
  const Transform patientFromIndex = labels.geometry.patientFromIndex();
  for (int k = box.first[2]; k < box.end[2]; ++k) {
    Vec3 sum;
    double count = 0;
    for (int j = box.first[1]; j < box.end[1]; ++j)
      for (int i = box.first[0]; i < box.end[0]; ++i)
        if (vessel.voxels.isSelected(i, j, k)) sum = sum + Vec3{double(i), double(j), double(k)}, ++count;
    if (count > 0) vessel.line.push_back(patientFromIndex * (sum / count));
  }
  return vessel;
}

Result<LabelMap> readMask(const CtVolume& ct, const std::filesystem::path& file) {
  auto read = readLabelMap(file);
  if (!read) return tl::unexpected(read.error());
  if (!sameGrid(read->labels.geometry, ct.geometry))
    return fail(file.filename().string() + " is on another grid than the CT beside it.");
  if (boundingBoxOf(read->labels, 1).empty()) return fail("There is no vessel in " + file.string() + ".");
  return std::move(read->labels);
}

Result<void> scoreMask(const CtVolume& ct, const Mask& mask, const LabelMap& labels,
                       const std::vector<LabelMap>& others, ScoreRows& rows, const Progress& progress) {
  const auto vessels = trueVessels(labels, 1, 1, kShortestVessel_mm, progress);
  if (!vessels) return tl::unexpected(vessels.error());
  const TrueVessel vessel = vessels->empty() ? stoutVessel(labels) : vessels->front();
  const auto where = around(ct, vessel, others, progress);
  if (!where) return tl::unexpected(where.error());
  const auto exact = scoreExactLumen(ct, betweenEnds(vessel.voxels, vessel.line), *where, progress);
  if (!exact) return tl::unexpected(exact.error());
  for (const int clicks : {2, 4}) {
    SegmentationScoreRow row;
    row.variant = "chest CTA", row.contrast = "arterial", row.structure = mask.name;
    row.exactLumen = *exact;
    if (clicks == 4) row.targetDice = kChestVesselBar;
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
  std::vector<LabelMap> masks;
  for (const Mask& mask : kMasks) {
    auto labels = readMask(imported->ct, folder / mask.file);
    if (!labels) return tl::unexpected(labels.error());
    masks.push_back(std::move(*labels));
  }
  auto falseLumen = readMask(imported->ct, folder / "aorta_false_lumen.nii.gz");
  if (!falseLumen) return tl::unexpected(falseLumen.error());
  ScoreRows rows;
  for (std::size_t n = 0; n < masks.size(); ++n) {
    std::vector<LabelMap> others{*falseLumen};
    for (std::size_t other = 0; other < masks.size(); ++other)
      if (other != n) others.push_back(masks[other]);
    if (auto ok = scoreMask(imported->ct, kMasks[n], masks[n], others, rows, progress); !ok)
      return tl::unexpected(ok.error());
  }
  return rows;
}

}  // namespace insonate::bench
