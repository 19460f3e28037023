#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/Curriculum.h>
#include <insonate/curriculum/SignedIn.h>
#include <insonate/curriculum/Unlocking.h>

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace insonate::cli {

/// Computes a person's present state in each level of a curriculum, from all attempts of the person.
Result<std::vector<LevelProgress>> levelPath(const SignedIn& by, const Curriculum& curriculum,
                                             const std::string& person);
/// Returns the first level of levelPath() that is open or lapsed; null if all are mastered.
const LevelProgress* levelAt(const std::vector<LevelProgress>& path);

/// Returns the name of a level's state: "locked", "open", "mastered" or "lapsed".
const char* nameOf(LevelState state);
nlohmann::json toJson(const Curriculum& curriculum, const std::vector<LevelProgress>& path);

}  // namespace insonate::cli
