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

/// One bit for each label that there may be.
using LabelSet = std::bitset<256>;

/// Voxels that a tool must leave unchanged.
struct EditRules {
  LabelSet locked;                    ///< labels that neither lose nor gain a voxel
  LabelSet hidden;                    ///< the same: what cannot be seen is not edited
  std::optional<HuRange> editable{};  ///< voxels of the CT outside it stay as they are
  LabelSet over = ~LabelSet();        ///< only voxels of these labels are overwritten

  /// Tells whether a voxel of this brightness may change from one label to the other.
  bool allow(std::uint8_t before, std::uint8_t after, int hu) const {
    const auto isFixed = [this](std::uint8_t label) { return locked.test(label) || hidden.test(label); };
    return !isFixed(before) && !isFixed(after) && over.test(before) && (!editable || editable->contains(hu));
  }
};

/// Removes from a proposal everything that the rules forbid or that would change nothing: it then shows what apply()
/// would write.
void restrictTo(const EditRules& rules, const CtVolume& ct, const LabelMap& labels, Proposal& proposal);

/// Extent of the change by an edit, an undo or a redo, so that slices and surfaces can be updated.
struct LabelChange {
  VoxelBox box;     ///< the smallest around all changed voxels; empty where nothing changed
  LabelSet labels;  ///< those that have lost or gained voxels
  std::size_t voxels = 0;
};

/// The only writer of labels. Stores each step as runs of changed voxels, so that a step costs a few bytes a run and
/// not a copy of the map: 100 steps, or as many of the latest as fit into the permitted memory. Reads the CT and
/// writes the label map of an owner, who keeps both alive and does not change them meanwhile; they are on one grid.
/// Not for two threads at once.
class LabelEdit {
 public:
  static constexpr std::size_t kMostSteps = 100;
  static constexpr std::size_t kMostBytes = std::size_t{256} << 20;

  LabelEdit(const CtVolume& ct, LabelMap& labels, std::size_t mostBytes = kMostBytes);

  const CtVolume& ct() const { return *ct_; }
  /// Replaces the CT by the same voxels in other memory.
  void setCt(const CtVolume& ct) { ct_ = &ct; }
  const LabelMap& labels() const { return labels_; }

  EditRules rules;

  /// Writes what the rules allow and remembers it as one step called `name`. A proposal that changes nothing is no
  /// step. Refuses a box that is not in the map, and labels that are locked or hidden where those are all it would
  /// write.
  Result<LabelChange> apply(const Proposal& proposal, std::string name);

  /// Combines all edits until endStroke() in one step.
  void beginStroke(std::string name);
  void endStroke();

  /// Name of the step that undo() or redo() would apply, for a menu; empty without one.
  std::optional<std::string_view> undoName() const;
  std::optional<std::string_view> redoName() const;
  LabelChange undo();
  LabelChange redo();

  std::size_t undoSteps() const { return done_.size(); }
  /// Memory that undo and redo take.
  std::size_t bytes() const;
  /// Grows with every change: a surface made at another revision is out of date.
  std::size_t revision() const { return revision_; }

 private:
  using Bytes = std::vector<std::uint8_t>;
  /// Difference made by one edit: the runs of each slice of the box, packed.
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
  std::size_t mostBytes_;
  std::deque<Step> done_;
  std::vector<Step> undone_;
  std::optional<std::string> stroke_;
  bool strokeHasStep_ = false;
  std::size_t revision_ = 0;
};

}  // namespace insonate
