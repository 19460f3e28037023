#pragma once

#include <insonate/core/Result.h>

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// Calls `write` with a path beside `target` (same extension), then moves that file over `target`. On any failure,
/// exceptions of `write` included, the target is as it was and nothing is left beside it. Errors of `write` that name
/// the path beside are made to name the target.
Result<void> writeAtomically(const std::filesystem::path& target,
                             const std::function<Result<void>(const std::filesystem::path& beside)>& write);

/// Writes a text or byte string in the same way.
Result<void> writeAtomically(const std::filesystem::path& target, std::string_view bytes);

/// Refuses, before any work, a target folder that could not be written later: empty name, a file or a link to nothing
/// in its place, a missing parent, missing rights.
Result<void> checkFolderTarget(const std::filesystem::path& target);

/// Writes a folder in the same way: `write` fills a new folder beside `target`, which is created when missing; its
/// other files stay. If files are replaced, the two folders change places in one step, after the old folder's other
/// files were copied: every reader, even after a kill, finds all files old or all new. `superseded` names files of the
/// old folder that must not survive beside the new ones. If the file system cannot swap folders, there are two steps,
/// between which the target is missing and both states lie beside it; if `target` is the current folder, which must
/// keep its identity, files are moved one by one.
Result<void> writeFolderAtomically(const std::filesystem::path& target,
                                   const std::function<Result<void>(const std::filesystem::path& beside)>& write,
                                   const std::vector<std::string_view>& superseded = {});

/// Removes the hidden folders that writeFolderAtomically() was filling in `parent` when its program was killed, for
/// one target's name or for all; each write does so for its own target. What any program is still writing stays, and
/// what lies beside a target that was lost between two steps.
void removeAbandonedParts(const std::filesystem::path& parent, const std::string& target = {});

}  // namespace insonate
