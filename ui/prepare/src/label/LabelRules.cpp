#include "LabelRules.h"

#include <algorithm>
#include <iterator>

namespace insonate::prepare {

LabelStep withRules(LabelStep step, const LabelRules& rules) {
  for (int label = 0; label < 256; ++label) {
    const auto value = std::uint8_t(label);
    const bool listed = std::ranges::find(step.locked, value) != step.locked.end();
    if (!rules.mayEdit(value) && !listed) step.locked.push_back(value);
  }
  if (!step.over && rules.over == LabelRules::Over::Filling)
    step.over.emplace(std::begin(kFilling), std::end(kFilling));
  if (!step.editable_HU) step.editable_HU = rules.editable;
  return step;
}

}  // namespace insonate::prepare
