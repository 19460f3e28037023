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

/// Writes a text or byte string to `target` through a temporary file that then replaces `target`. On failure `target`
/// is unchanged.
Result<void> writeAtomically(const std::filesystem::path& target, std::string_view bytes);

/// Checks, before any work, whether a folder can be written as `target`. Refuses an empty name, a `target` that is a
/// file or a dangling link, a missing parent folder, and missing permissions.
Result<void> checkFolderTarget(const std::filesystem::path& target);

/// Writes the folder `target` atomically: `write` fills a new folder beside `target`, and this folder then takes the
/// place of `target`. A missing `target` is created. Other files of an existing `target` are kept, except those named
/// in `superseded`. If files are replaced, the two folders are exchanged in one step, so that every reader finds either
/// all old or all new files, even if the program is killed. If the file system cannot exchange folders, the replacement
/// takes two steps; between the steps, `target` is missing and both folders lie beside it. If `target` is the current
/// working folder, the new files are moved into it one by one, because the folder itself must stay.
Result<void> writeFolderAtomically(const std::filesystem::path& target,
                                   const std::function<Result<void>(const std::filesystem::path& beside)>& write,
                                   const std::vector<std::string_view>& superseded = {});

/// Removes from `parent` the hidden, unfinished folders that writeFolderAtomically() left when its program was killed:
/// those for `target`, or those for any target if `target` is empty. writeFolderAtomically() calls this function for
/// its own target. Folders that a running program is still writing are kept, and so are both folders of a target whose
/// two-step replacement was interrupted.
void removeAbandonedParts(const std::filesystem::path& parent, const std::string& target = {});

}  // namespace insonate
