#pragma once

#include <insonate/curriculum/Curriculum.h>

#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// The sentence that a trainee reads at one turn of a level's story.
struct StoryTurn {
  enum class When {
    Beginning,     ///< no attempt anywhere
    Reached,       ///< what it builds on is mastered
    AfterFailure,  ///< the first attempt here failed
    AfterPass,     ///< one attempt passed, which is not enough
    Mastered,
    Lapsed,  ///< too long without practice
  };
  When when = When::Beginning;
  std::string sentence{};  ///< LevelProgress::why
};

/// Returns the story of a trainee who first fails and then always passes. Turns that the level's rule does not have
/// are left out. `curriculum` comes from parseCurriculum() and contains the level.
std::vector<StoryTurn> levelStory(const Curriculum& curriculum, std::string_view level);

}  // namespace insonate
