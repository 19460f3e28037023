#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/curriculum/Curriculum.h>

#include <filesystem>
#include <string>
#include <vector>

namespace insonate::cli {

inline constexpr int kDemonstrations = 3;

/// Attempts that come along (`session --script`) at a level's built-in case, as recordings "NAME SCRIPT.attempt" in a
/// folder, which is made: a success, one in two passes and a puncture of the artery, the first `most` of them. About
/// ten seconds each. Cancelled, what was recorded until then stays.
Result<std::vector<std::filesystem::path>> recordDemonstrations(const Level& level, const std::filesystem::path& folder,
                                                                const std::string& name, int most,
                                                                const Progress& progress);

}  // namespace insonate::cli
