#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/curriculum/SiteUpload.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace insonate {

/// Result of a download of cases.
struct CaseDownloadReport {
  std::vector<std::string> titles{};  ///< cases of which a new version was downloaded
  /// Sentences about cases that could not be downloaded, with what to do. The former versions of these cases stay.
  std::vector<std::string> errors{};
};

/// Downloads from a server the published cases in `titles` that `folder` does not contain yet. Creates `folder` if it
/// is missing, with access only for the user who runs the program. An interrupted download continues at the first
/// missing byte. Each case is read and compared with its fingerprint before it is used; a case that does not match its
/// fingerprint is not downloaded again on the same day. Earlier versions are kept, so that attempts on them can be
/// replayed. Fails if the server cannot be reached, if another program is downloading to the folder, or if cancelled.
/// Cases that were complete before a failure can be used.
Result<CaseDownloadReport> downloadCases(const SiteLink& server, const std::vector<std::string>& titles,
                                         const std::filesystem::path& folder, const Progress& progress = {});

struct DownloadState {
  bool isExpected = false;                       ///< true: the server offers a case with this title
  std::optional<std::filesystem::path> place{};  ///< case folder of the newest complete version
};
/// Returns the state of the server's case with this title, as of the last call of downloadCases() for this folder:
/// whether the server offers the case, and where the downloaded copy is.
DownloadState downloadStateOf(const std::filesystem::path& folder, const std::string& title);

/// Returns the case folder of the downloaded version with this voxelHashOf(), which may also be an earlier version. No
/// value if there is none.
std::optional<std::filesystem::path> downloadedVersion(const std::filesystem::path& folder,
                                                       const std::string& voxelHash);

/// Returns the case folders of the newest complete versions of all cases.
std::vector<std::filesystem::path> downloadedCases(const std::filesystem::path& folder);

}  // namespace insonate
