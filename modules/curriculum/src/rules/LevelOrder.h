#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/Curriculum.h>

#include <vector>

namespace insonate {

/// Sorts levels so that each follows its prerequisites, and otherwise keeps their order. Fails with a sentence about a
/// prerequisite that is unknown, named twice, or circular.
Result<std::vector<Level>> inOrderOfLearning(std::vector<Level> levels);

}  // namespace insonate
