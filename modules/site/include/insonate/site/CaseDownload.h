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
  std::vector<std::string> troubles{};
};

/// Downloads those published cases of a server whose titles are in `titles`, and that are not yet in the folder
/// `folder`, which is created for its owner alone. An interrupted download continues at the first missing byte. Each
/// case is read and compared with its fingerprint before it is used; a case that does not fit is not downloaded again
/// on the same day. Earlier versions are kept, so that attempts on them can be replayed. Fails if the server cannot be
/// reached, if another program is downloading to the folder, or if cancelled; cases that were complete until then can
/// be used.
Result<CaseDownloadReport> downloadCases(const SiteLink& server, const std::vector<std::string>& titles,
                                         const std::filesystem::path& folder, const Progress& progress = {});

struct DownloadState {
  bool isExpected = false;                       ///< true: the server offers a case with this title
  std::optional<std::filesystem::path> place{};  ///< case folder of the newest complete version
};
/// Tells whether the server offers a case with this title, as of the last download, and where the case is.
DownloadState downloadStateOf(const std::filesystem::path& folder, const std::string& title);

/// Returns the case folder of a downloaded version with this voxelHashOf(), whether or not it is the last version. No
/// value if there is none.
std::optional<std::filesystem::path> downloadedVersion(const std::filesystem::path& folder,
                                                       const std::string& voxelHash);

/// Returns the case folders of the newest complete versions of all cases.
std::vector<std::filesystem::path> downloadedCases(const std::filesystem::path& folder);

}  // namespace insonate
