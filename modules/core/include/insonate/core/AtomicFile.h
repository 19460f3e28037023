#pragma once

#include <insonate/core/Result.h>

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// Calls `write` with the path of a temporary file beside `target` (same extension), then moves that file over
/// `target`. On any failure, exceptions of `write` included, `target` is unchanged and the temporary file is removed.
/// If an error of `write` names the temporary file, the returned error names `target` instead.
Result<void> writeAtomically(const std::filesystem::path& target,
                             const std::function<Result<void>(const std::filesystem::path& beside)>& write);

/// Writes a text or byte string to `target` in the same atomic way.
Result<void> writeAtomically(const std::filesystem::path& target, std::string_view bytes);

/// Checks, before any work, whether a folder can be written as `target`. Refuses an empty name, a file or a dangling
/// link in its place, a missing parent folder, and missing permissions.
Result<void> checkFolderTarget(const std::filesystem::path& target);

/// Writes a folder in the same way: `write` fills a new folder beside `target`. `target` is created if it is missing;
/// its other files are kept. If files are replaced, the two folders are exchanged in one step, after the old folder's
/// other files were linked or copied into the new one: every reader finds either all old or all new files, even if the
/// program is killed. `superseded` names files of the old folder that are not kept. If the file system cannot exchange
/// folders, the replacement takes two steps; between them `target` is missing and both folders lie beside it. If
/// `target` is the current folder, which must keep its identity, the new files are moved into it one by one.
Result<void> writeFolderAtomically(const std::filesystem::path& target,
                                   const std::function<Result<void>(const std::filesystem::path& beside)>& write,
                                   const std::vector<std::string_view>& superseded = {});

/// Removes the hidden folders that writeFolderAtomically() was filling in `parent` when its program was killed: those
/// of `target`, or of all targets if it is empty. writeFolderAtomically() calls this for its own target. Folders that a
/// running program is still writing are kept, and so are both folders of a target whose two-step replacement was
/// interrupted.
void removeAbandonedParts(const std::filesystem::path& parent, const std::string& target = {});

}  // namespace insonate
