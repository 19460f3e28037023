#pragma once

#include <insonate/curriculum/Curriculum.h>

#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// A situation in the course of a level, with the sentence that the trainee then reads.
struct StoryTurn {
  enum class When {
    Beginning,     ///< no attempt at any level yet
    Reached,       ///< all prerequisites are mastered
    AfterFailure,  ///< the first attempt at this level failed
    AfterPass,     ///< an attempt passed, but more passes are needed for mastery
    Mastered,
    Lapsed,  ///< lapsed after too long without practice
  };
  When when = When::Beginning;
  std::string sentence{};  ///< LevelProgress::why
};

/// Returns the course of a trainee who first fails and then always passes. Situations that cannot occur under the
/// level's rule are left out. `curriculum` comes from parseCurriculum() and contains the level.
std::vector<StoryTurn> levelStory(const Curriculum& curriculum, std::string_view level);

}  // namespace insonate
