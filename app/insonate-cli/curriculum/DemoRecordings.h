#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/curriculum/Curriculum.h>

#include <filesystem>
#include <string>
#include <vector>

namespace insonate::cli {

inline constexpr int kDemonstrations = 3;

/// Records the first `most` of the built-in scripted attempts (`session --script`) at a level's built-in case: a
/// success, an attempt in two passes, and a puncture of the artery. The files are named "NAME SCRIPT.attempt"; the
/// folder is created if it is missing. Takes about ten seconds for each. If cancelled, the finished recordings stay.
Result<std::vector<std::filesystem::path>> recordDemonstrations(const Level& level, const std::filesystem::path& folder,
                                                                const std::string& name, int most,
                                                                const Progress& progress);

}  // namespace insonate::cli
