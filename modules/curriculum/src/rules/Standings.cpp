#include <insonate/curriculum/Judgement.h>
#include <insonate/curriculum/Standings.h>

#include <algorithm>

namespace insonate {
namespace {

/// Tells whether the last attempts at a level all failed.
bool failsOn(const Level& level, const Curriculum& curriculum, std::span<const AttemptFacts> history) {
  int failed = 0;
  for (auto it = history.rbegin(); it != history.rend() && failed < kStuckAfter; ++it) {
    const auto passed = levelOf(curriculum, *it) == &level ? passedIn(curriculum, *it) : std::nullopt;
    if (!passed) continue;
    if (*passed) return false;
    ++failed;
  }
  return failed == kStuckAfter;
}

/// When the clock advances, times that were in the future are accepted (Unlocking.h).
std::int64_t nextBelieved_us(std::span<const AttemptFacts> history, std::int64_t now_us) {
  std::int64_t next_us = kForever_us;
  for (const AttemptFacts& attempt : history)
    if (attempt.begun_us > now_us) next_us = std::min(next_us, attempt.begun_us);
  return next_us;
}

void findConcern(Standing& standing, const Curriculum& curriculum, std::span<const AttemptFacts> history,
                 std::span<const LevelProgress> progress) {
  if (const auto lapsed = std::ranges::find(progress, LevelState::Lapsed, &LevelProgress::state);
      lapsed != progress.end()) {
    standing.concern = Concern::Slipped, standing.sentence = lapsed->why;
    return;
  }
  for (const LevelProgress& one : progress) {
    const Level* level = curriculum.level(one.level);
    if (one.state != LevelState::Open || !level || !failsOn(*level, curriculum, history)) continue;
    standing.concern = Concern::Stuck, standing.sentence = one.why;
    return;
  }
}

}  // namespace

Standing computeStanding(const Curriculum& curriculum, std::span<const AttemptFacts> history,
                         std::span<const LevelProgress> progress, std::int64_t now_us, std::int64_t changes) {
  Standing standing{.curriculum = curriculum.name,
                    .curriculumVersion = curriculum.version,
                    .sentence = "All levels are mastered.",
                    .changes = changes,
                    .from_us = now_us,
                    .until_us = nextBelieved_us(history, now_us)};
  const auto isDue = [](LevelState state) { return state == LevelState::Open || state == LevelState::Lapsed; };
  standing.mastered = static_cast<int>(std::ranges::count(progress, LevelState::Mastered, &LevelProgress::state));
  if (const auto due = std::ranges::find_if(progress, isDue, &LevelProgress::state); due != progress.end())
    standing.level = due->level, standing.sentence = due->why;
  findConcern(standing, curriculum, history, progress);
  for (const LevelProgress& one : progress) standing.until_us = std::min(standing.until_us, one.until_us);
  return standing;
}

}  // namespace insonate
