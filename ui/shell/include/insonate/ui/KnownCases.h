#pragma once

#include <insonate/ui/RecentCases.h>

#include <QString>
#include <QStringList>
#include <optional>
#include <string>
#include <vector>

namespace insonate::ui {

/// Returns the names of the built-in necks (cases/Phantom.h), easiest first.
QStringList builtInCaseNames();

/// Returns the folder to which published cases of the site's server are downloaded (site/CaseDownload.h).
QString downloadFolder();
/// Tells whether a folder is that of a downloaded case, which must not be changed.
bool isDownloaded(const QString& folder);

/// Tells whether the site's server offers a case with this title, but the case is not downloaded yet.
bool isBeingDownloaded(const QString& title);

/// Folders that the user has added to the case library.
QStringList libraryFolders();
void setLibraryFolders(const QStringList& folders);

/// Reads the titles of the cases in the library's folders and their subfolders. Takes seconds if there are many cases
/// or if the folders are on a slow network.
std::vector<RecentCase> libraryCases();

/// Searches the built-in, the downloaded, the recent and the library's cases, in this order, for a case with this
/// title, or for a built-in case with this name. Returns the folder of the case, or the name of the built-in case.
/// Empty if there is no such case. Also empty while the case with this title is being downloaded (isBeingDownloaded()),
/// since attempts on another version would not count.
std::optional<QString> findCaseLocation(const QString& nameOrTitle);
/// Returns the folder of the version with this voxelHashOf(), which is a downloaded version or a version of the case
/// that findCaseLocation() finds; empty if this version was not kept.
std::optional<QString> placeOfVersion(const QString& nameOrTitle, const std::string& voxelHash);

/// Returns the location from which trainees open the case at `place` (a folder or the name of a built-in case): the
/// folder of its published version, if there is one; else `place` itself.
QString trainingLocation(const QString& place);

/// Returns the title of the built-in neck with this name; any other text is returned unchanged.
QString builtInTitle(const QString& nameOrTitle);

}  // namespace insonate::ui
