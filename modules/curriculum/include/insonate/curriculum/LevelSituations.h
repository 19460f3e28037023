#pragma once

#include <insonate/curriculum/Curriculum.h>

#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// A situation of a trainee at a level, with the sentence that the program then shows to the trainee.
struct LevelSituation {
  enum class When {
    Beginning,     ///< before the first attempt at any level of the curriculum
    Reached,       ///< all prerequisites of this level have just been mastered
    AfterFailure,  ///< after a first, failed attempt at this level
    AfterPass,     ///< after a passed attempt at this level, while mastery requires more passes
    Mastered,
    Lapsed,  ///< mastery has lapsed after too many days without practice
  };
  When when = When::Beginning;
  std::string sentence{};  ///< sentence for the trainee: LevelProgress::why
};

/// Returns the situations of a trainee who first fails at a level and then always passes, as a preview for the author
/// of the curriculum. Situations that the rules of the level exclude are left out. `curriculum` comes from
/// parseCurriculum() and contains the level.
std::vector<LevelSituation> levelSituations(const Curriculum& curriculum, std::string_view level);

}  // namespace insonate
