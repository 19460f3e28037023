#pragma once

#include "LevelRecord.h"

#include <insonate/curriculum/Unlocking.h>

#include <string>
#include <vector>

namespace insonate {

/// A prerequisite of a level that is not mastered at present; `lapsed`: it was mastered before.
struct Obstacle {
  const LevelRecord* record = nullptr;
  bool lapsed = false;
};

/// The outcome of the last attempt in a sentence about a level.
enum class LastAttempt { Stated, Omitted };

/// Writes LevelProgress::why, or LevelProgress::summary if the last attempt is omitted: a sentence for the trainee on
/// why a level has this state.
std::string levelSentence(const LevelRecord& record, LevelState state, const std::vector<Obstacle>& obstacles,
                          std::int64_t now_us, LastAttempt last);

}  // namespace insonate
