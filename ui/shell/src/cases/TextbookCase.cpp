#include "TextbookCase.h"

#include <insonate/cases/Phantom.h>

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <filesystem>
#include <system_error>

namespace insonate::ui {
namespace {

constexpr std::uint32_t kSeed = 1;
constexpr double kShareOfMaking = 0.75;
const QString kPrefix = QStringLiteral("textbook-");

/// A part of longer work.
Progress part(const Progress& whole, double from, double to) {
  return [whole, from, to](std::string_view doing, double fraction) {
    return report(whole, doing, from + (to - from) * fraction);
  };
}

void forgetOthers(const QString& kept) {
  QDir cache = QFileInfo(kept).dir();
  for (const QString& name : cache.entryList({kPrefix + QLatin1Char('*')}, QDir::Dirs))
    if (cache.filePath(name) != kept) QDir(cache.filePath(name)).removeRecursively();
}

}  // namespace

QString textbookFolder() {
  const QFileInfo program(QCoreApplication::applicationFilePath());
  const QString version =
      QString::number(program.lastModified().toSecsSinceEpoch(), 16) + QString::number(program.size(), 16);
  return QDir(QStandardPaths::writableLocation(QStandardPaths::CacheLocation)).filePath(kPrefix + version);
}

Result<PatientCase> textbookCase(const QString& folder, const Progress& progress) {
  const std::filesystem::path place(folder.toStdString());
  std::error_code ignored;
  if (std::filesystem::exists(place / "case.json", ignored)) {
    if (!report(progress, "reading", 0)) return fail(std::string(kCancelled));
    if (auto kept = readCase(place)) return std::move(kept->patient);
  }
  auto made = makePhantom(phantomVariants().front().name, kSeed, part(progress, 0, kShareOfMaking));
  if (!made) return made;
  QDir().mkpath(QFileInfo(folder).path());
  if (writeCase(*made, place, part(progress, kShareOfMaking, 1))) forgetOthers(folder);
  return made;
}

}  // namespace insonate::ui
