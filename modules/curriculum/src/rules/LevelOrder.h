#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/Curriculum.h>

#include <vector>

namespace insonate {

/// Levels so that none comes before its prerequisites, otherwise in their order. Fails with the sentence of what is
/// wrong with a prerequisite: unknown, named twice, or part of a circle.
Result<std::vector<Level>> inOrderOfLearning(std::vector<Level> levels);

}  // namespace insonate
