#include "LevelPath.h"

#include "Answer.h"

#include <insonate/curriculum/AttemptStore.h>

#include <algorithm>
#include <chrono>

namespace insonate::cli {
namespace {

std::int64_t now_us() {
  return std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::system_clock::now().time_since_epoch())
      .count();
}

}  // namespace

Result<std::vector<LevelProgress>> levelPath(const SignedIn& by, const Curriculum& curriculum,
                                             const std::string& person) {
  const auto history = AttemptStore(by).history(person);
  if (!history) return tl::unexpected(history.error());
  return computeProgress(curriculum, *history, now_us());
}

const LevelProgress* levelAt(const std::vector<LevelProgress>& path) {
  const auto found = std::ranges::find_if(
      path, [](const LevelProgress& p) { return p.state == LevelState::Open || p.state == LevelState::Lapsed; });
  return found == path.end() ? nullptr : &*found;
}

const char* nameOf(LevelState state) {
  switch (state) {
    case LevelState::Locked:
      return "locked";
    case LevelState::Open:
      return "open";
    case LevelState::Mastered:
      return "mastered";
    case LevelState::Lapsed:
      break;
  }
  return "lapsed";
}

Json toJson(const Curriculum& curriculum, const std::vector<LevelProgress>& path) {
  Json levels = Json::array();
  for (const LevelProgress& progress : path) {
    const Level* level = curriculum.level(progress.level);
    Json row{{"level", progress.level},
             {"title", level ? level->title : ""},
             {"state", nameOf(progress.state)},
             {"why", progress.why},
             {"since", progress.since_us ? Json(timeText(*progress.since_us)) : Json(nullptr)},
             {"attempts", progress.attempts},
             {"passes", progress.passes},
             {"passes_in_a_row", progress.consecutivePasses},
             {"cusum", progress.cusum},
             {"passes_needed", nullptr},
             {"fewest_attempts", nullptr},
             {"cusum_limit", nullptr},
             {"cusum_acceptable", nullptr},
             {"cusum_unacceptable", nullptr},
             {"cusum_signalled", nullptr}};
    if (level)
      row.update(
          {{"passes_needed", level->mastery.consecutivePasses}, {"fewest_attempts", fewestAttempts(level->mastery)}});
    if (level && level->mastery.cusum)
      row.update({{"cusum_limit", level->mastery.cusum->limit},
                  {"cusum_acceptable", level->mastery.cusum->acceptable},
                  {"cusum_unacceptable", level->mastery.cusum->unacceptable},
                  {"cusum_signalled", progress.cusumSignaled}});
    levels.push_back(std::move(row));
  }
  return levels;
}

}  // namespace insonate::cli
