#include "RunCode.h"

#include <insonate/segmentation/LabelEdit.h>
#include <insonate/tissue/Labels.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <utility>

namespace insonate {
namespace {

/// Change of one slice of a box.
struct SliceChange {
  std::array<int, 2> first{1 << 30, 1 << 30}, end{0, 0};
  LabelSet labels;
  std::size_t voxels = 0;

  void add(int i, int j, std::uint8_t before, std::uint8_t after) {
    first = {std::min(first[0], i), std::min(first[1], j)};
    end = {std::max(end[0], i + 1), std::max(end[1], j + 1)};
    labels.set(before).set(after);
    ++voxels;
  }
};

void join(LabelChange& all, const LabelChange& part) {
  all.box = united(all.box, part.box);
  all.labels |= part.labels;
  all.voxels += part.voxels;
}

}  // namespace

void removeForbiddenChanges(const EditRules& rules, const CtVolume& ct, const LabelMap& labels, Proposal& proposal) {
  const VoxelBox& box = proposal.box;
  tbb::parallel_for(box.first[2], box.end[2], [&](int k) {
    for (int j = box.first[1]; j < box.end[1]; ++j) {
      std::uint8_t* wanted = &proposal.labels.at(0, j - box.first[1], k - box.first[2]);
      for (int i = box.first[0]; i < box.end[0]; ++i, ++wanted) {
        const std::uint8_t label = labels.at(i, j, k);
        if (*wanted == Proposal::kKeep || *wanted == label) continue;
        if (!rules.allow(label, *wanted, ct.at(i, j, k))) *wanted = Proposal::kKeep;
      }
    }
  });
}

LabelEdit::LabelEdit(const CtVolume& ct, LabelMap& labels, std::size_t maxUndoBytes)
    : ct_(&ct), labels_(labels), maxUndoBytes_(maxUndoBytes) {}

Result<LabelChange> LabelEdit::apply(const Proposal& proposal, std::string name) {
  if (auto ok = check(proposal); !ok) return tl::unexpected(ok.error());
  if (proposal.box.empty()) return LabelChange{};
  Difference difference = write(proposal);
  const LabelChange change = difference.change;
  if (change.voxels == 0) return change;
  ++revision_;
  remember(std::move(difference), std::move(name));
  return change;
}

Result<void> LabelEdit::check(const Proposal& proposal) const {
  if (intersected(proposal.box, boxOf(labels_.geometry)) != proposal.box && !proposal.box.empty())
    return fail("The region of the tool lies outside the label map. Choose a region inside it.");
  const LabelSet fixed = rules.locked | rules.hidden;
  if (fixed.none()) return {};
  LabelSet written;
  for (const std::uint8_t label : proposal.labels.voxels) written.set(label);
  written.reset(Proposal::kKeep);
  if (written.none() || (written & ~fixed).any()) return {};
  const auto label = static_cast<std::uint8_t>(written._Find_first());
  return fail("The label " + labelName(label) + " is " +
              (rules.locked.test(label) ? "locked; unlock it to edit it." : "hidden; show it to edit it."));
}

LabelEdit::Difference LabelEdit::write(const Proposal& proposal) {
  const VoxelBox& box = proposal.box;
  const int ni = labels_.geometry.size[0];
  Difference difference;
  difference.slices.resize(box.length(2));
  std::vector<SliceChange> changes(box.length(2));
  tbb::parallel_for(0, box.length(2), [&](int slice) {
    segmentation::RunPacker packer;
    const int k = box.first[2] + slice;
    for (int j = box.first[1]; j < box.end[1]; ++j) {
      const std::uint8_t* wanted = &proposal.labels.at(0, j - box.first[1], slice);
      for (int i = box.first[0]; i < box.end[0]; ++i, ++wanted) {
        std::uint8_t& label = labels_.at(i, j, k);
        if (*wanted == Proposal::kKeep || *wanted == label) continue;
        if (!rules.allow(label, *wanted, ct_->at(i, j, k))) continue;
        packer.add(std::size_t(j) * ni + i, label, *wanted);
        changes[slice].add(i, j, label, *wanted);
        label = *wanted;
      }
    }
    difference.slices[slice] = packer.take();
  });
  for (int slice = 0; slice < box.length(2); ++slice) {
    const SliceChange& c = changes[slice];
    if (c.voxels == 0) continue;
    const int k = box.first[2] + slice;
    join(difference.change, {{{c.first[0], c.first[1], k}, {c.end[0], c.end[1], k + 1}}, c.labels, c.voxels});
  }
  if (difference.change.voxels == 0) return {};
  // Only changed slices are stored.
  auto& slices = difference.slices;
  slices.erase(slices.begin() + (difference.change.box.end[2] - box.first[2]), slices.end());
  slices.erase(slices.begin(), slices.begin() + (difference.change.box.first[2] - box.first[2]));
  return difference;
}

void LabelEdit::remember(Difference difference, std::string name) {
  undone_.clear();
  if (!stroke_ || !strokeHasStep_) done_.push_back({stroke_ ? *stroke_ : std::move(name), {}, 0});
  strokeHasStep_ = stroke_.has_value();
  Step& step = done_.back();
  step.bytes += sizeof(Difference);
  for (const Bytes& slice : difference.slices) step.bytes += sizeof(Bytes) + slice.size();
  step.differences.push_back(std::move(difference));
  forgetOldest();
}

/// A step larger than the whole memory limit can still be undone while it is the latest.
void LabelEdit::forgetOldest() {
  while (done_.size() > 1 && (done_.size() > kMaxSteps || bytes() > maxUndoBytes_)) done_.pop_front();
}

void LabelEdit::beginStroke(std::string name) {
  stroke_ = std::move(name);
  strokeHasStep_ = false;
}

void LabelEdit::endStroke() {
  stroke_.reset();
  strokeHasStep_ = false;
}

std::optional<std::string_view> LabelEdit::undoName() const {
  if (done_.empty()) return std::nullopt;
  return done_.back().name;
}

std::optional<std::string_view> LabelEdit::redoName() const {
  if (undone_.empty()) return std::nullopt;
  return undone_.back().name;
}

LabelChange LabelEdit::undo() {
  if (done_.empty()) return {};
  endStroke();
  undone_.push_back(std::move(done_.back()));
  done_.pop_back();
  return replay(undone_.back(), true);
}

LabelChange LabelEdit::redo() {
  if (undone_.empty()) return {};
  endStroke();
  done_.push_back(std::move(undone_.back()));
  undone_.pop_back();
  return replay(done_.back(), false);
}

LabelChange LabelEdit::replay(const Step& step, bool back) {
  LabelChange all;
  const std::size_t slice = std::size_t(labels_.geometry.size[0]) * labels_.geometry.size[1];
  const std::size_t count = step.differences.size();
  for (std::size_t n = 0; n < count; ++n) {
    const Difference& difference = step.differences[back ? count - 1 - n : n];
    tbb::parallel_for(std::size_t{0}, difference.slices.size(), [&](std::size_t s) {
      std::uint8_t* const first = labels_.voxels.data() + (difference.change.box.first[2] + s) * slice;
      segmentation::unpackRuns(difference.slices[s], [&](const segmentation::ChangedRun& run) {
        std::fill_n(first + run.begin, run.length, back ? run.before : run.after);
      });
    });
    join(all, difference.change);
  }
  ++revision_;
  return all;
}

std::size_t LabelEdit::bytes() const {
  std::size_t sum = 0;
  for (const Step& step : done_) sum += step.bytes;
  for (const Step& step : undone_) sum += step.bytes;
  return sum;
}

}  // namespace insonate
