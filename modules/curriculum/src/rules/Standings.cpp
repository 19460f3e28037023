#include <insonate/curriculum/Standings.h>

#include <algorithm>

namespace insonate {

Standing standingOf(const Curriculum& curriculum, std::span<const LevelProgress> progress, std::int64_t changes) {
  Standing standing{curriculum.name, curriculum.version, "", 0, "All levels are mastered.", changes};
  const auto isDue = [](LevelState state) { return state == LevelState::Open || state == LevelState::Lapsed; };
  standing.mastered = static_cast<int>(std::ranges::count(progress, LevelState::Mastered, &LevelProgress::state));
  if (const auto due = std::ranges::find_if(progress, isDue, &LevelProgress::state); due != progress.end())
    standing.level = due->level, standing.sentence = due->why;
  return standing;
}

}  // namespace insonate
