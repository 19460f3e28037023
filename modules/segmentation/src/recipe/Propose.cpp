#include "StepFields.h"
#include "edit/Surroundings.h"

#include <insonate/segmentation/AutoLabel.h>
#include <insonate/segmentation/Brush.h>
#include <insonate/segmentation/FillBetweenSlices.h>
#include <insonate/segmentation/Islands.h>
#include <insonate/segmentation/Smoothing.h>
#include <insonate/segmentation/Threshold.h>
#include <insonate/tissue/Labels.h>

#include <algorithm>

namespace insonate {
namespace {

LabelSet setOf(const std::vector<std::uint8_t>& labels) {
  LabelSet set;
  for (const std::uint8_t label : labels) set.set(label);
  return set;
}

/// Region in which a step may write: the whole grid by default.
VoxelBox regionOf(const LabelStep& step, const VolumeGeometry& grid) {
  if (!step.box_mm) return boxOf(grid);
  const Transform indexFromPatient = grid.indexFromPatient();
  VoxelBox box;
  for (const Vec3& corner_mm : *step.box_mm) {
    const std::array at = nearestVoxel(indexFromPatient * corner_mm);
    box = united(box, {at, {at[0] + 1, at[1] + 1, at[2] + 1}});
  }
  return intersected(box, boxOf(grid));
}

/// Erasing paints with the rest label, so that erased voxels differ from the rest that was there before.
void leaveWhatIsSo(const LabelMap& labels, Proposal& proposal) {
  const VoxelBox& box = proposal.box;
  for (int k = box.first[2]; k < box.end[2]; ++k)
    for (int j = box.first[1]; j < box.end[1]; ++j) {
      std::uint8_t* wanted = &proposal.labels.at(0, j - box.first[1], k - box.first[2]);
      for (int i = box.first[0]; i < box.end[0]; ++i, ++wanted)
        if (*wanted == labels.at(i, j, k)) *wanted = Proposal::kKeep;
    }
}

/// Such tools decide themselves on the label of each voxel.
bool writesSeveralLabels(const LabelTool& tool) {
  return std::holds_alternative<step::Auto>(tool) || std::holds_alternative<step::GrowSeeds>(tool) ||
         std::holds_alternative<step::Watershed>(tool) || std::holds_alternative<step::SmoothTogether>(tool) ||
         std::holds_alternative<step::SplitIslands>(tool);
}

/// Runs one tool of a step: an overload for each.
class Proposer {
 public:
  Proposer(const LabelStep& step, const CtVolume& ct, const LabelMap& labels, const Progress& progress)
      : step_(step), ct_(ct), labels_(labels), progress_(progress) {}

  Result<Proposal> operator()(const step::Auto& s) const {
    auto found = autoLabel(ct_, progress_);
    if (!found) return tl::unexpected(found.error());
    const LabelSet take = setOf(s.take);
    if (take.any())
      for (std::uint8_t& label : found->voxels)
        if (!take.test(label)) label = Proposal::kKeep;
    return Proposal{boxOf(ct_.geometry), std::move(*found)};
  }
  Result<Proposal> operator()(const step::Threshold& s) const {
    Selection chosen(ct_.geometry, region());
    threshold(ct_, s.range_HU, chosen);
    return proposePainting(std::move(chosen), step_.label);
  }
  Result<Proposal> operator()(const step::Paint& s) const {
    Selection chosen = strokeVoxels(ct_.geometry, s.points_mm, {.radius_mm = s.radius_mm, .sliceAxis = s.sliceAxis});
    if (s.only_HU) removeOutside(ct_, *s.only_HU, chosen);
    return proposePainting(std::move(chosen), step_.label);
  }
  Result<Proposal> operator()(const step::Draw& s) const {
    return write(polygonVoxels(ct_.geometry, s.sliceAxis, s.points_mm));
  }
  Result<Proposal> operator()(const step::Scissors& s) const {
    return write(scissorsVoxels(ct_.geometry, region(), s.points_mm, s.view));
  }
  Result<Proposal> operator()(const step::KeepLargest& s) const {
    return reshape(largestIslands(shape(0), s.islands, progress_));
  }
  Result<Proposal> operator()(const step::RemoveSmall& s) const {
    return reshape(islandsOfMinimumVolume(shape(0), s.min_mm3, progress_));
  }
  Result<Proposal> operator()(const step::KeepIsland& s) const {
    return reshape(islandAt(shape(0), s.points_mm.front(), progress_));
  }
  Result<Proposal> operator()(const step::SplitIslands& s) const { return splitIslands(shape(0), s.into, progress_); }
  Result<Proposal> operator()(const step::Median& s) const {
    return reshape(medianSmoothed(shape(s.radius_mm), s.radius_mm, progress_));
  }
  Result<Proposal> operator()(const step::Opening& s) const {
    return reshape(opened(shape(s.radius_mm), s.radius_mm, progress_));
  }
  Result<Proposal> operator()(const step::Closing& s) const {
    return reshape(closed(shape(2 * s.radius_mm), s.radius_mm, progress_));
  }
  Result<Proposal> operator()(const step::Gaussian& s) const {
    return reshape(gaussianSmoothed(shape(3 * s.sigma_mm), s.sigma_mm, progress_));
  }
  Result<Proposal> operator()(const step::SmoothTogether& s) const {
    return jointlySmoothed(labels_, extentOfAll(s.labels, 3 * s.sigma_mm), setOf(s.labels), s.sigma_mm, progress_);
  }
  Result<Proposal> operator()(const step::Margin& s) const {
    const Selection before = shape(std::max(s.margin_mm, 0.0));
    return reshape(s.margin_mm >= 0 ? grownBy(before, s.margin_mm, progress_)
                                    : shrunkBy(before, -s.margin_mm, progress_));
  }
  Result<Proposal> operator()(const step::Hollow& s) const {
    return reshape(makeShell(shape(s.thickness_mm), s.thickness_mm, s.wall, progress_));
  }
  Result<Proposal> operator()(const step::Logical& s) const {
    // A label subtracted from itself is cleared.
    const bool mayVanish = s.operation == LogicalOperation::kAdd || s.with == step_.label;
    if (!mayVanish && s.reach_mm == 0)
      return fail(
          "No voxel has two labels, so the intersection is empty. Set a reach above 0 mm: voxels within this distance "
          "of the other label then count as that label.");
    const VoxelBox box = extentOfAll({step_.label, s.with}, s.reach_mm);
    const auto other = grownBy(voxelsOf(labels_, s.with, box), s.reach_mm, progress_);
    if (!other) return tl::unexpected(other.error());
    const Selection before = voxelsOf(labels_, step_.label, box);
    Selection after = combined(before, s.operation, *other, ct_.geometry);
    if (!mayVanish && after.count() == 0 && before.count() > 0)
      return fail("Nothing of the label would be left. Use another reach, or combine with another label.");
    return reshape(std::move(after));
  }
  Result<Proposal> operator()(const step::FillBetween& s) const {
    return reshape(fillBetweenSlices(shape(kAroundShape_mm), s.sliceAxis, progress_));
  }
  Result<Proposal> operator()(const step::Connected& s) const {
    return write(connected(ct_, region(), s.points_mm, s.range_HU, progress_));
  }
  Result<Proposal> operator()(const step::ConfidenceConnected& s) const {
    return write(confidenceConnected(ct_, region(), s.points_mm, s.confidence, progress_));
  }
  Result<Proposal> operator()(const step::GrowSeeds& s) const {
    return grownFromSeeds(ct_, seedsOf(labels_, extentOfAll(s.seeds, kAroundShape_mm), setOf(s.seeds), setOf(s.over)),
                          s.competition, progress_);
  }
  Result<Proposal> operator()(const step::Watershed& s) const {
    return watershed(ct_, seedsOf(labels_, extentOfAll(s.seeds, kAroundShape_mm), setOf(s.seeds), setOf(s.over)),
                     s.smoothing_mm, progress_);
  }
  Result<Proposal> operator()(const step::March& s) const {
    const VoxelBox box = step_.box_mm ? region() : boxAround(ct_.geometry, s.points_mm, s.front.reach_mm);
    return write(fastMarching(ct_, box, s.points_mm, s.front, progress_));
  }
  Result<Proposal> operator()(const step::Contour& s) const {
    return reshape(levelSet(ct_, shape(kAroundLevelSet_mm), s.levelSet, progress_));
  }
  Result<Proposal> operator()(const step::Vessel& s) const {
    return lumen(trackVessel(ct_, s.points_mm, s.tracking, progress_));
  }
  Result<Proposal> operator()(const step::Tube& s) const {
    return lumen(trackTube(ct_, s.points_mm, s.tracking, progress_));
  }
  Result<Proposal> operator()(const step::Outline& s) const {
    return reshapedVessel(labels_, step_.label, step_.rest, s.outline);
  }
  Result<Proposal> operator()(const step::CutOff& s) const {
    auto part = partCutOff(labels_, step_.label, s.stroke, progress_);
    if (!part) return tl::unexpected(part.error());
    return proposePainting(std::move(*part), step_.rest);
  }

 private:
  static constexpr double kAroundShape_mm = 10, kAroundLevelSet_mm = 20;

  VoxelBox region() const { return regionOf(step_, ct_.geometry); }
  /// The label in the step's region, or in its bounding box with a margin.
  Selection shape(double margin_mm) const {
    return voxelsOf(labels_, step_.label, extentOfAll({step_.label}, margin_mm));
  }
  VoxelBox extentOfAll(const std::vector<std::uint8_t>& labels, double margin_mm) const {
    if (step_.box_mm) return region();
    VoxelBox all;
    for (const std::uint8_t label : labels) all = united(all, boundingBoxOf(labels_, label));
    return grown(all, ct_.geometry, margin_mm);
  }
  Result<Proposal> write(Result<Selection> chosen) const {
    if (!chosen) return tl::unexpected(chosen.error());
    return proposePainting(std::move(*chosen), step_.label);
  }
  Result<Proposal> lumen(Result<TrackedVessel> vessel) const {
    if (!vessel) return tl::unexpected(vessel.error());
    return proposePainting(std::move(vessel->lumen), step_.label);
  }
  Result<Proposal> reshape(Result<Selection> shape) const {
    if (!shape) return tl::unexpected(shape.error());
    return proposeShape(std::move(*shape), labels_, step_.label, step_.rest);
  }

  const LabelStep& step_;
  const CtVolume& ct_;
  const LabelMap& labels_;
  const Progress& progress_;
};

}  // namespace

LabelStep::LabelStep() : rest(kSoftTissue) {}

std::string_view nameOf(const LabelTool& tool) {
  return segmentation::kToolNames[tool.index()];
}

Result<Proposal> propose(const LabelStep& step, const CtVolume& ct, const LabelMap& labels, const Progress& progress) {
  if (step.rest != LabelStep::kSurroundings) return std::visit(Proposer(step, ct, labels, progress), step.tool);
  // The tools write a label that differs from their own, which is then replaced where it removes a label.
  LabelStep marked = step;
  marked.rest = step.label == kSoftTissue ? kBackground : kSoftTissue;
  const bool erases = step.label == step.rest;
  if (erases) marked.label = marked.rest;
  auto proposal = std::visit(Proposer(marked, ct, labels, progress), marked.tool);
  if (!proposal || writesSeveralLabels(step.tool)) return proposal;
  LabelSet removed = erases ? (step.over ? setOf(*step.over) : ~LabelSet()) : LabelSet().set(step.label);
  segmentation::takeSurroundings(ct, labels, removed.reset(kBackground), marked.rest, *proposal);
  return proposal;
}

Result<void> preview(const LabelStep& step, const CtVolume& ct, const LabelMap& labels, Proposal& into,
                     const Progress& progress) {
  const EditRules rules = rulesOf(step);
  if (const auto* s = std::get_if<step::Threshold>(&step.tool)) {
    proposeThreshold(ct, s->range_HU, step.label, rules, labels, regionOf(step, ct.geometry), into);
    return {};
  }
  auto made = propose(step, ct, labels, progress);
  if (!made) return tl::unexpected(made.error());
  removeForbiddenChanges(rules, ct, labels, *made);
  if (step.label == step.rest) leaveWhatIsSo(labels, *made);
  into = std::move(*made);
  return {};
}

EditRules rulesOf(const LabelStep& step) {
  EditRules rules{.locked = setOf(step.locked), .hidden = {}, .editable = step.editable_HU};
  if (step.over) rules.over = setOf(*step.over).set(step.label);
  return rules;
}

Result<LabelChange> perform(const LabelStep& step, LabelEdit& edit, const Progress& progress) {
  auto proposal = propose(step, edit.ct(), edit.labels(), progress);
  if (!proposal) return tl::unexpected(proposal.error());
  EditRules rules = rulesOf(step);
  std::swap(edit.rules, rules);
  auto change = edit.apply(*proposal, std::string(nameOf(step.tool)));
  std::swap(edit.rules, rules);
  return change;
}

}  // namespace insonate
