#pragma once

#include <insonate/segmentation/LabelStep.h>
#include <insonate/tissue/Labels.h>

#include <optional>

namespace insonate::prepare {

/// The author's rules about voxels that tools must not change. They apply to all tools, except where a step has its own
/// rules.
struct LabelRules {
  /// Labels that may be overwritten, unless they are locked or hidden.
  enum class Over {
    Every,
    Filling,    ///< labels that fill the body between named structures (kFilling)
    Unlabeled,  ///< only unlabeled voxels (kUnlabeled)
    Inside      ///< one label: `inside`
  };

  LabelSet locked, hidden;
  Over over = Over::Every;
  std::uint8_t inside = kBackground;  ///< the label that may be overwritten if Over::Inside is selected
  std::optional<HuRange> editable;

  bool mayEdit(std::uint8_t label) const { return !locked.test(label) && !hidden.test(label); }
};

/// Labels that fill the body between named structures. Overwriting only these preserves earlier work.
inline constexpr std::uint8_t kFilling[] = {kBackground, kFat, kMuscle, kSoftTissue};

/// Labels of voxels without a structure: soft tissue, and the space outside the patient.
inline constexpr std::uint8_t kUnlabeled[] = {kBackground, kSoftTissue};

/// Returns the step with these rules; rules that the step already has are kept.
LabelStep withRules(LabelStep step, const LabelRules& rules);

}  // namespace insonate::prepare
