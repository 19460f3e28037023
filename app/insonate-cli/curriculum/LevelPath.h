#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/Curriculum.h>
#include <insonate/curriculum/SignedIn.h>
#include <insonate/curriculum/Unlocking.h>

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace insonate::cli {

/// A person's present state in each level, computed from all attempts.
Result<std::vector<LevelProgress>> levelPath(const SignedIn& by, const Curriculum& curriculum,
                                             const std::string& person);
/// The level they are at: the first to be renewed or learnt; null: all are mastered.
const LevelProgress* levelAt(const std::vector<LevelProgress>& path);

/// "locked", "open", "mastered" or "lapsed".
const char* nameOf(LevelState state);
nlohmann::json toJson(const Curriculum& curriculum, const std::vector<LevelProgress>& path);

}  // namespace insonate::cli
