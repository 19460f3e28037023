#include "LabelRules.h"

#include <algorithm>
#include <iterator>

namespace insonate::prepare {
namespace {

std::optional<std::vector<std::uint8_t>> overwritten(const LabelRules& rules) {
  using Labels = std::vector<std::uint8_t>;
  switch (rules.over) {
    case LabelRules::Over::Filling:
      return Labels(std::begin(kFilling), std::end(kFilling));
    case LabelRules::Over::Unlabeled:
      return Labels(std::begin(kUnlabeled), std::end(kUnlabeled));
    case LabelRules::Over::Inside:
      return Labels{rules.inside};
    default:
      return std::nullopt;
  }
}

}  // namespace

LabelStep withRules(LabelStep step, const LabelRules& rules) {
  for (int label = 0; label < 256; ++label) {
    const auto value = std::uint8_t(label);
    const bool listed = std::ranges::find(step.locked, value) != step.locked.end();
    if (!rules.mayEdit(value) && !listed) step.locked.push_back(value);
  }
  if (!step.over) step.over = overwritten(rules);
  if (!step.editable_HU) step.editable_HU = rules.editable;
  return step;
}

}  // namespace insonate::prepare
