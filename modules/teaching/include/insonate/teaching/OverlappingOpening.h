#pragma once

#include <insonate/curriculum/OpeningStore.h>

#include <cstdint>
#include <vector>

namespace insonate {

/// Returns the first of these openings that is open, or opens later, for the same test during the period of a new
/// opening: a second opening is probably a mistake, since each of the two suffices to take the test. Returns null if
/// there is none. `opening.curriculum` must be set; an empty start means now. The pointer is valid as long as
/// `openings` is.
const TestOpening* overlappingOpening(const std::vector<TestOpening>& openings, const NewOpening& opening,
                                      std::int64_t now_us);

}  // namespace insonate
