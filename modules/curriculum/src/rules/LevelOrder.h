#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/Curriculum.h>

#include <vector>

namespace insonate {

/// Sorts levels so that none precedes its prerequisites, otherwise in their order. Fails with a sentence about the
/// prerequisite: unknown, named twice, or part of a circle.
Result<std::vector<Level>> inOrderOfLearning(std::vector<Level> levels);

}  // namespace insonate
