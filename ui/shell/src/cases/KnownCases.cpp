#include "LibraryReader.h"

#include <insonate/cases/CaseListing.h>
#include <insonate/cases/CaseVersions.h>
#include <insonate/cases/Phantom.h>
#include <insonate/site/CaseDownload.h>
#include <insonate/ui/KnownCases.h>
#include <insonate/ui/Text.h>

#include <QDir>
#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>

namespace insonate::ui {
namespace {

const QString kLibraryFolders = QStringLiteral("library/folders");

}  // namespace

QStringList builtInCaseNames() {
  QStringList names;
  for (const PhantomVariant& one : phantomVariants()) names << qt(one.name);
  return names;
}

QString downloadFolder() {
  return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/downloaded-cases");
}

bool isDownloaded(const QString& folder) {
  const QString downloads = QDir(downloadFolder()).canonicalPath();
  return !downloads.isEmpty() && QFileInfo(QFileInfo(folder).canonicalFilePath()).path() == downloads;
}

bool isBeingDownloaded(const QString& title) {
  const DownloadState state = downloadStateOf(downloadFolder().toStdString(), title.toStdString());
  return state.isExpected && !state.place;
}

QStringList libraryFolders() {
  return QSettings().value(kLibraryFolders).toStringList();
}

void setLibraryFolders(const QStringList& folders) {
  QSettings().setValue(kLibraryFolders, folders);
}

std::vector<RecentCase> libraryCases() {
  std::vector<RecentCase> cases;
  for (const QString& folder : casesIn(libraryFolders()))
    if (const auto manifest = readCaseManifest(folder.toStdString())) cases.push_back({folder, qt(manifest->title)});
  return cases;
}

std::optional<QString> findCaseLocation(const QString& nameOrTitle) {
  if (const PhantomVariant* builtIn = phantomVariant(nameOrTitle.toStdString())) return qt(builtIn->name);
  const DownloadState downloaded = downloadStateOf(downloadFolder().toStdString(), nameOrTitle.toStdString());
  if (downloaded.place) return QString::fromStdString(downloaded.place->string());
  if (downloaded.isExpected) return std::nullopt;
  for (const auto& cases : {recentCases, libraryCases})
    for (const RecentCase& one : cases())
      if (one.title == nameOrTitle) return one.folder;
  return std::nullopt;
}

std::optional<QString> placeOfVersion(const QString& nameOrTitle, const std::string& voxelHash) {
  if (const auto kept = downloadedVersion(downloadFolder().toStdString(), voxelHash))
    return QString::fromStdString(kept->string());
  const auto place = findCaseLocation(nameOrTitle);
  const auto kept = place ? findVersion(place->toStdString(), voxelHash) : std::nullopt;
  return kept ? std::optional(QString::fromStdString(kept->string())) : std::nullopt;
}

QString trainingLocation(const QString& place) {
  return builtInCaseNames().contains(place) ? place
                                            : QString::fromStdString(caseForTraining(place.toStdString()).string());
}

QString builtInTitle(const QString& nameOrTitle) {
  const PhantomVariant* builtIn = phantomVariant(nameOrTitle.toStdString());
  return builtIn ? qt(builtIn->title) : nameOrTitle;
}

}  // namespace insonate::ui
