#pragma once

#include <insonate/core/Result.h>

#include <filesystem>
#include <functional>
#include <string_view>

namespace insonate {

/// Calls `write` with a path beside `target` (same extension), then moves that file over `target`. On any failure,
/// exceptions of `write` included, the target is as it was and nothing is left beside it.
Result<void> writeAtomically(const std::filesystem::path& target,
                             const std::function<Result<void>(const std::filesystem::path& beside)>& write);

/// The same for a text or byte string.
Result<void> writeAtomically(const std::filesystem::path& target, std::string_view bytes);

/// The same for a folder: `write` fills a fresh folder beside `target`. Files of that folder then replace files of the
/// same name in `target`, which is created when missing; its other files stay.
Result<void> writeFolderAtomically(const std::filesystem::path& target,
                                   const std::function<Result<void>(const std::filesystem::path& beside)>& write);

}  // namespace insonate
