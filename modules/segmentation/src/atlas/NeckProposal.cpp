#include "Guarded.h"
#include "NeckFit.h"
#include "NeckTissue.h"
#include "NeckVessels.h"

#include <insonate/segmentation/NeckProposal.h>
#include <insonate/tissue/Labels.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace insonate {
namespace {

using namespace segmentation;

struct StructureInfo {
  std::string_view name;
  Label label;
};
constexpr std::array<StructureInfo, kNeckStructures> kInfo{{{"right common carotid artery", kArtery},
                                                            {"left common carotid artery", kArtery},
                                                            {"right internal jugular vein", kVein},
                                                            {"left internal jugular vein", kVein},
                                                            {"thyroid", kThyroid},
                                                            {"right sternocleidomastoid", kSternocleidomastoid},
                                                            {"left sternocleidomastoid", kSternocleidomastoid}}};

/// Removes from a selection the voxels of another selection, and those that touch it.
void keepApart(Selection& from, const Selection& other) {
  if (from.box.empty() || other.box.empty()) return;
  constexpr std::array<std::array<int, 3>, 7> kNear{
      {{0, 0, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};
  for (int k = 0; k < from.box.length(2); ++k)
    for (int j = 0; j < from.box.length(1); ++j)
      for (int i = 0; i < from.box.length(0); ++i)
        for (const auto& off : kNear)
          if (other.isSelected(i + from.box.first[0] + off[0], j + from.box.first[1] + off[1],
                               k + from.box.first[2] + off[2]))
            from.mask.at(i, j, k) = 0;
}

std::string questionFor(NeckStructure structure) {
  return "Click the " + std::string(nameOf(structure)) + " in this slice.";
}

/// Lowers a confidence if the atlas does not fit the CT. Built-in necks that the atlas does not contain have a mismatch
/// of at most about 0.20; with real necks, it was 0.33 to 0.41.
double withMismatch(double confidence, const std::vector<FittedNeck>& necks) {
  constexpr double kUsual = 0.2, kPerMismatch = 25;
  double mismatch = 0;
  for (const FittedNeck& neck : necks) mismatch += neck.map.mismatch / double(necks.size());
  const double odds = confidence / (1 - confidence) * std::exp(-kPerMismatch * std::max(0.0, mismatch - kUsual));
  return odds / (1 + odds);
}

ProposedStructure proposed(NeckStructure structure) {
  ProposedStructure one;
  one.structure = structure;
  return one;
}

void proposeVessels(const CtVolume& ct, const std::vector<FittedNeck>& necks, std::vector<ProposedStructure>& all,
                    Work& work) {
  std::vector<TakenStation> taken;
  for (std::size_t n = 0; n < kNeckVessels; ++n) {
    ProposedStructure& one = all[n];
    const auto expected = expectedCourse(necks, one.structure, ct.geometry);
    if (expected.empty()) continue;
    one.ask_mm = expected[expected.size() / 2].center_mm;
    auto vessel = foundVessel(ct, expected, labelOf(one.structure) == kArtery, taken, work);
    if (!vessel) continue;
    taken.insert(taken.end(), vessel->taken.begin(), vessel->taken.end());
    one.ask_mm = vessel->weakest_mm;
    one.confidence = confidenceOf(vessel->signs);
    one.line = std::move(vessel->tracked.line);
    one.voxels = std::move(vessel->tracked.lumen);
  }
}

}  // namespace

std::string_view nameOf(NeckStructure structure) {
  return kInfo[std::size_t(structure)].name;
}

std::uint8_t labelOf(NeckStructure structure) {
  return kInfo[std::size_t(structure)].label;
}

std::vector<ProposedStructure> segmentation::proposalsFrom(const CtVolume& ct, const std::vector<FittedNeck>& necks,
                                                           Work& work) {
  std::vector<ProposedStructure> all;
  for (std::size_t n = 0; n < kNeckStructures; ++n) all.push_back(proposed(static_cast<NeckStructure>(n)));
  work.start("Finding vessels");
  proposeVessels(ct, necks, all, work);
  work.start("Finding thyroid and muscles");
  const StructureShares shares = structureShares(necks, work);
  for (std::size_t n = kNeckVessels; n < kNeckStructures; ++n) proposeTissue(ct, shares, all[n], work);

  for (std::size_t n = 0; n < kNeckStructures; ++n)
    for (std::size_t m = 0; m < n; ++m)
      if (m < kNeckVessels) keepApart(all[n].voxels, all[m].voxels);
  for (ProposedStructure& one : all)
    if (one.confidence = withMismatch(one.confidence, necks); one.confidence < kHighConfidence)
      one.question = questionFor(one.structure);
  return all;
}

Result<std::vector<ProposedStructure>> proposeNeck(const CtVolume& ct, const LabelMap& automatic,
                                                   std::span<const AtlasNeck> atlas, const Progress& progress) {
  if (!sameGrid(ct.geometry, automatic.geometry))
    return fail("The automatic labels are not on the grid of the CT. Label this CT automatically first.");
  return guarded([&]() -> Result<std::vector<ProposedStructure>> {
    constexpr double kPasses = 60;
    Work work(progress, kPasses);
    work.start("Fitting the atlas to the CT");
    const auto necks = fittedNecks(ct, automatic, atlas, work);
    if (necks.empty())
      return fail("No neck was found in this CT. Crop the CT to the neck, or label its structures with the guide.");
    return proposalsFrom(ct, necks, work);
  });
}

}  // namespace insonate
