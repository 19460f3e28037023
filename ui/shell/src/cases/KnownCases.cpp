#include <insonate/cases/CaseVersions.h>
#include <insonate/cases/Phantom.h>
#include <insonate/site/CaseDownload.h>
#include <insonate/ui/KnownCases.h>
#include <insonate/ui/RecentCases.h>
#include <insonate/ui/Text.h>

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

namespace insonate::ui {

QStringList builtInNames() {
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

std::optional<QString> placeOfCase(const QString& nameOrTitle) {
  for (const PhantomVariant& one : phantomVariants())
    if (nameOrTitle == qt(one.name) || nameOrTitle == qt(one.title)) return qt(one.name);
  if (const auto place = downloadedCase(downloadFolder().toStdString(), nameOrTitle.toStdString()))
    return QString::fromStdString(place->string());
  for (const RecentCase& one : recentCases())
    if (one.title == nameOrTitle) return one.folder;
  return std::nullopt;
}

std::optional<QString> placeOfVersion(const QString& nameOrTitle, const std::string& voxelHash) {
  if (const auto kept = downloadedVersion(downloadFolder().toStdString(), voxelHash))
    return QString::fromStdString(kept->string());
  const auto place = placeOfCase(nameOrTitle);
  const auto kept = place ? findVersion(place->toStdString(), voxelHash) : std::nullopt;
  return kept ? std::optional(QString::fromStdString(kept->string())) : std::nullopt;
}

QString placeForTraining(const QString& place) {
  return builtInNames().contains(place) ? place : QString::fromStdString(caseForTraining(place.toStdString()).string());
}

QString titleOfCase(const QString& nameOrTitle) {
  for (const PhantomVariant& one : phantomVariants())
    if (nameOrTitle == qt(one.name)) return qt(one.title);
  return nameOrTitle;
}

}  // namespace insonate::ui
