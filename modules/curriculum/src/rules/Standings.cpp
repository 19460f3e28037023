#include <insonate/curriculum/Judgement.h>
#include <insonate/curriculum/Standings.h>

#include <algorithm>

namespace insonate {
namespace {

/// The last attempts at a level all failed.
bool failsOn(const Level& level, const Curriculum& curriculum, std::span<const AttemptFacts> history) {
  int failed = 0;
  for (auto it = history.rbegin(); it != history.rend() && failed < kStuckAfter; ++it) {
    if (it->level != level.name || it->curriculum != curriculum.name || !counts(*it)) continue;
    if (judge(level.pass, *it).passed) return false;
    ++failed;
  }
  return failed == kStuckAfter;
}

}  // namespace

Standing standingOf(const Curriculum& curriculum, std::span<const LevelProgress> progress, std::int64_t changes) {
  Standing standing{curriculum.name, curriculum.version, "", 0, "All levels are mastered.", changes};
  const auto isDue = [](LevelState state) { return state == LevelState::Open || state == LevelState::Lapsed; };
  standing.mastered = static_cast<int>(std::ranges::count(progress, LevelState::Mastered, &LevelProgress::state));
  if (const auto due = std::ranges::find_if(progress, isDue, &LevelProgress::state); due != progress.end())
    standing.level = due->level, standing.sentence = due->why;
  return standing;
}

PersonStanding personStanding(const Curriculum& curriculum, std::span<const AttemptFacts> history,
                              std::span<const LevelProgress> progress, std::int64_t changes) {
  PersonStanding result{standingOf(curriculum, progress, changes), Concern::None, {}};
  result.sentence = result.standing.sentence;
  const auto lapsed = std::ranges::find(progress, LevelState::Lapsed, &LevelProgress::state);
  if (lapsed != progress.end()) {
    result.concern = Concern::Slipped;
    result.sentence = lapsed->why;
    return result;
  }
  for (const LevelProgress& one : progress) {
    const Level* level = curriculum.level(one.level);
    if (one.state != LevelState::Open || !level || !failsOn(*level, curriculum, history)) continue;
    result.concern = Concern::Stuck;
    result.sentence = one.why;
    break;
  }
  return result;
}

}  // namespace insonate
