#pragma once

#include "LevelRecord.h"

#include <insonate/curriculum/Unlocking.h>

#include <string>
#include <vector>

namespace insonate {

/// A prerequisite that is not mastered at present, and whether it was mastered once.
struct Obstacle {
  const LevelRecord* record = nullptr;
  bool lapsed = false;
};

/// Writes LevelProgress::why.
std::string levelSentence(const LevelRecord& record, LevelState state, const std::vector<Obstacle>& obstacles,
                          std::int64_t now_us);

}  // namespace insonate
