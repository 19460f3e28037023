#pragma once

#include <insonate/core/Result.h>
#include <insonate/segmentation/Region.h>

#include <bitset>
#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// Set of labels: one bit for each possible label.
using LabelSet = std::bitset<256>;

/// Rules that determine which voxels a tool must leave unchanged.
struct EditRules {
  LabelSet locked;                    ///< labels that must not gain or lose voxels
  LabelSet hidden;                    ///< hidden labels, which must not change because the author does not see them
  std::optional<HuRange> editable{};  ///< if set, voxels with CT values outside this range are not changed
  LabelSet over = ~LabelSet();        ///< labels whose voxels may be overwritten; all labels by default

  /// Tells whether a voxel with this CT value may change from label `before` to label `after`.
  bool allow(std::uint8_t before, std::uint8_t after, int hu) const {
    const auto isFixed = [this](std::uint8_t label) { return locked.test(label) || hidden.test(label); };
    return !isFixed(before) && !isFixed(after) && over.test(before) && (!editable || editable->contains(hu));
  }
};

/// Removes from a proposal all changes that the rules forbid, and all entries that would change nothing. The proposal
/// then contains exactly the changes that apply() would write.
void removeForbiddenChanges(const EditRules& rules, const CtVolume& ct, const LabelMap& labels, Proposal& proposal);

/// Extent of a change by an edit, an undo or a redo, for updating slices and surfaces.
struct LabelChange {
  VoxelBox box;     ///< the smallest box around all changed voxels; empty if nothing changed
  LabelSet labels;  ///< labels that have lost or gained voxels
  std::size_t voxels = 0;
};

/// Edits a label map, with undo and redo. Each undo step stores runs of changed voxels, a few bytes for each run,
/// instead of a copy of the map. The latest 100 steps are kept, or fewer if they exceed the memory limit. CT and label
/// map must be on one grid, must outlive the object, and must not be changed by others. Two threads must not use one
/// object concurrently.
class LabelEdit {
 public:
  static constexpr std::size_t kMaxSteps = 100;
  static constexpr std::size_t kMaxUndoBytes = std::size_t{256} << 20;

  /// `maxUndoBytes`: maximum memory of the undo and redo steps.
  LabelEdit(const CtVolume& ct, LabelMap& labels, std::size_t maxUndoBytes = kMaxUndoBytes);

  const CtVolume& ct() const { return *ct_; }
  /// Replaces the reference to the CT, e.g. after the CT was copied. The voxels of the new CT must be identical.
  void setCt(const CtVolume& ct) { ct_ = &ct; }
  const LabelMap& labels() const { return labels_; }

  EditRules rules;

  /// Writes those changes of the proposal that the rules allow, and stores them as one undo step called `name`. A
  /// proposal that changes nothing is not stored. Refuses a box outside the map, and a proposal that would write only
  /// locked or hidden labels.
  Result<LabelChange> apply(const Proposal& proposal, std::string name);

  /// Combines all edits until endStroke() in one undo step called `name`.
  void beginStroke(std::string name);
  void endStroke();

  /// Names, for a menu, of the steps that undo() and redo() would apply; no value if there is no such step.
  std::optional<std::string_view> undoName() const;
  std::optional<std::string_view> redoName() const;
  LabelChange undo();
  LabelChange redo();

  std::size_t undoSteps() const { return done_.size(); }
  /// Returns the number of bytes of memory that the stored undo and redo steps take.
  std::size_t bytes() const;
  /// Returns a number that increases with every change of the labels. Results that were computed at a smaller number
  /// are outdated.
  std::size_t revision() const { return revision_; }

 private:
  using Bytes = std::vector<std::uint8_t>;
  /// Change made by one edit: the changed voxels of each slice of the box, packed as runs (RunPacker).
  struct Difference {
    LabelChange change;
    std::vector<Bytes> slices;
  };
  struct Step {
    std::string name;
    std::vector<Difference> differences;
    std::size_t bytes = 0;
  };

  Result<void> check(const Proposal& proposal) const;
  Difference write(const Proposal& proposal);
  LabelChange replay(const Step& step, bool back);
  void remember(Difference difference, std::string name);
  void forgetOldest();

  const CtVolume* ct_;
  LabelMap& labels_;
  std::size_t maxUndoBytes_;
  std::deque<Step> done_;
  std::vector<Step> undone_;
  std::optional<std::string> stroke_;
  bool strokeHasStep_ = false;
  std::size_t revision_ = 0;
};

}  // namespace insonate
