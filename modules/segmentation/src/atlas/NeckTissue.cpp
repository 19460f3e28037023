#include "NeckTissue.h"

#include "vessel/SectionLine.h"

#include <insonate/tissue/Labels.h>

#include <algorithm>
#include <cmath>

namespace insonate::segmentation {
namespace {

constexpr float kPossible = 0.12F, kCore = 0.85F;
constexpr double kTissueBlur_mm = 0.6, kDeviations = 3, kOdds = -0.8;

/// Box of the voxels at which a structure is possible.
VoxelBox possibleBox(const StructureShares& shares, NeckStructure structure, const VolumeGeometry& ct) {
  const auto& share = shares.share[std::size_t(structure) - kNeckVessels];
  const Transform ctFromShares = ct.indexFromPatient() * shares.geometry.patientFromIndex();
  VoxelBox box;
  for (int k = 0; k < shares.geometry.size[2]; ++k)
    for (int j = 0; j < shares.geometry.size[1]; ++j)
      for (int i = 0; i < shares.geometry.size[0]; ++i) {
        if (share[shares.geometry.offset(i, j, k)] < kPossible) continue;
        const auto [a, b, c] = nearestVoxel(ctFromShares * Vec3{double(i), double(j), double(k)});
        if (!ct.contains(a, b, c)) continue;
        box = united(box, {{a, b, c}, {a + 1, b + 1, c + 1}});
      }
  return box.empty() ? box : grown(box, ct, 2);
}

/// Confidence by the CT value of the core, by the share of the core that has this value, and by the volume relative to
/// that in the atlas.
double confidenceOf(NeckStructure structure, double core_HU, double coreShare, double volume) {
  // Without contrast agent, iodine makes the thyroid brighter than muscle (60 to 120 HU); contrast agent adds to this.
  const bool isThyroid = structure == NeckStructure::Thyroid;
  const bool isUsual = isThyroid ? core_HU > 60 && core_HU < 260 : core_HU > 30 && core_HU < 95;
  const double sum = (isUsual ? 3.5 : 0) - 12 * (1 - coreShare) - 4 * std::abs(std::log(std::max(volume, 0.05)));
  return 1 / (1 + std::exp(-sum));
}

}  // namespace

void proposeTissue(const CtVolume& ct, const StructureShares& shares, ProposedStructure& to, Work& work) {
  const VoxelBox box = possibleBox(shares, to.structure, ct.geometry);
  if (box.empty()) return;
  const CtVolume smooth = blurredPart(ct, box, kTissueBlur_mm);
  Volume<float> share(smooth.geometry);
  const Transform patientFromIndex = smooth.geometry.patientFromIndex();
  work.slices(smooth.geometry.size[2], [&](int k) {
    for (int j = 0; j < smooth.geometry.size[1]; ++j)
      for (int i = 0; i < smooth.geometry.size[0]; ++i)
        share.at(i, j, k) =
            static_cast<float>(shares.at(to.structure, patientFromIndex * Vec3{double(i), double(j), double(k)}));
  });
  std::vector<double> core_HU, off_HU;
  for (std::size_t v = 0; v < share.voxels.size(); ++v)
    if (share.voxels[v] > kCore) core_HU.push_back(smooth.voxels[v]);
  if (core_HU.empty()) return;
  const double level_HU = medianOf(core_HU);
  for (const double hu : core_HU) off_HU.push_back(std::abs(hu - level_HU));
  const double sd_HU = std::clamp(1.48 * medianOf(off_HU), 8.0, 30.0);
  to.voxels = Selection(ct.geometry, box);
  double expected = 0, found = 0, core = 0, foundCore = 0;
  for (std::size_t v = 0; v < share.voxels.size(); ++v) {
    const double off = (smooth.voxels[v] - level_HU) / (kDeviations * sd_HU);
    // Log odds of the atlas, and of a value like that of the core.
    const double p = std::clamp(double(share.voxels[v]), 0.01, 0.99);
    const double odds = std::log(p / (1 - p)) + 1.2 * (1 - std::min(off * off, 4.0));
    const bool isFound = odds > kOdds && p > kPossible;
    to.voxels.mask.voxels[v] = isFound ? 1 : 0;
    expected += p > kPossible ? p : 0, found += isFound ? 1 : 0;
    if (p > kCore) core += 1, foundCore += isFound ? 1 : 0;
  }
  to.ask_mm = smooth.geometry.center_mm();
  to.confidence = confidenceOf(to.structure, level_HU, foundCore / core, found / expected);
}

}  // namespace insonate::segmentation
