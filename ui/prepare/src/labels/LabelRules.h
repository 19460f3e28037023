#pragma once

#include <insonate/segmentation/LabelStep.h>
#include <insonate/tissue/Labels.h>

#include <optional>

namespace insonate::prepare {

/// The author's rules about voxels that tools must leave unchanged; for the whole window, where a step has rules of
/// its own.
struct LabelRules {
  /// Labels that may be overwritten, among those that are neither locked nor hidden.
  enum class Over {
    Every,
    Filling,     ///< what lies between structures that have a name
    Unlabelled,  ///< what has no label yet
    Inside       ///< one label
  };

  LabelSet locked, hidden;
  Over over = Over::Every;
  std::uint8_t inside = kBackground;  ///< the label of Over::Inside
  std::optional<HuRange> editable;

  bool mayEdit(std::uint8_t label) const { return !locked.test(label) && !hidden.test(label); }
};

/// Labels that fill the body between named structures: overwriting nothing else spares earlier work.
inline constexpr std::uint8_t kFilling[] = {kBackground, kFat, kMuscle, kSoftTissue};

/// Soft tissue is everything else, as is the space outside the patient.
inline constexpr std::uint8_t kUnlabelled[] = {kBackground, kSoftTissue};

/// The step with these rules, but for those it has itself.
LabelStep withRules(LabelStep step, const LabelRules& rules);

}  // namespace insonate::prepare
