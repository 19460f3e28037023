#include <insonate/teaching/OverlappingOpening.h>

#include <algorithm>

namespace insonate {

const TestOpening* overlappingOpening(const std::vector<TestOpening>& openings, const NewOpening& opening,
                                      std::int64_t now_us) {
  const std::int64_t start_us = opening.start_us.value_or(now_us);
  const auto found = std::ranges::find_if(openings, [&](const TestOpening& one) {
    const OpeningState state = stateAt(one, now_us);
    return one.curriculum == opening.curriculum && one.level == opening.level &&
           (state == OpeningState::Open || state == OpeningState::Waiting) &&
           (!opening.end_us || one.start_us < *opening.end_us) && (!one.end_us || start_us < *one.end_us);
  });
  return found == openings.end() ? nullptr : &*found;
}

}  // namespace insonate
