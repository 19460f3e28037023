#pragma once

#include <insonate/curriculum/Curriculum.h>

#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// What a trainee reads of a level at a turn of its story.
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

/// Of someone who first fails and then passes each time; turns that the level's rule does not know are left out.
/// `curriculum` is one that parseCurriculum() gave, and has the level.
std::vector<StoryTurn> levelStory(const Curriculum& curriculum, std::string_view level);

}  // namespace insonate
