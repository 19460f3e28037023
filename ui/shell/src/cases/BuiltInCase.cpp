#include "BuiltInCase.h"

#include <insonate/cases/Phantom.h>
#include <insonate/core/ThreadPriority.h>
#include <insonate/ui/CaseLoader.h>
#include <insonate/ui/KnownCases.h>

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <QThreadPool>
#include <filesystem>
#include <system_error>

namespace insonate::ui {
namespace {

constexpr std::uint32_t kSeed = 1;

/// Identity of this program, since other versions make other necks. Read once: its file may be replaced while it runs.
const QString& version() {
  static const QString once = [] {
    const QFileInfo program(QCoreApplication::applicationFilePath());
    return QString::number(program.lastModified().toSecsSinceEpoch(), 16) + QString::number(program.size(), 16);
  }();
  return once;
}

void forgetOfOthers(QDir cache) {
  const QString ours = QLatin1Char('-') + version();
  for (const QString& neck : builtInCaseNames())
    for (const QString& name : cache.entryList({neck + QStringLiteral("-*")}, QDir::Dirs))
      if (!name.endsWith(ours)) QDir(cache.filePath(name)).removeRecursively();
}

QThreadPool& keeper() {
  static QThreadPool pool;
  return pool;
}

/// Stops when the program ends, without incomplete files. For a thread of its own, which keeps its low priority.
void keep(const PatientCase& patient, const QString& folder) {
  lowerThreadPriority();  // the first image has precedence, since compressing the CT takes a second
  QDir().mkpath(QFileInfo(folder).path());
  const auto goOn = [](std::string_view, double) { return !QCoreApplication::closingDown(); };
  if (writeCase(patient, folder.toStdString(), goOn)) forgetOfOthers(QFileInfo(folder).dir());
}

}  // namespace

void waitForBuiltInCache() {
  keeper().waitForDone();
}

QString builtInFolder(const QString& variant) {
  return QDir(QStandardPaths::writableLocation(QStandardPaths::CacheLocation))
      .filePath(variant + QLatin1Char('-') + version());
}

Result<std::shared_ptr<const PatientCase>> builtInCase(const QString& variant, const QString& folder,
                                                       const Progress& progress) {
  const std::filesystem::path place(folder.toStdString());
  std::error_code ignored;
  if (std::filesystem::exists(place / "case.json", ignored)) {
    if (!report(progress, "reading", 0)) return fail(std::string(kCancelled));
    if (auto kept = readCase(place)) return std::make_shared<const PatientCase>(std::move(kept->patient));
  }
  auto made = makePhantom(variant.toStdString(), kSeed, progress);
  if (!made) return tl::unexpected(made.error());
  auto patient = std::make_shared<const PatientCase>(std::move(*made));
  keeper().start([patient, folder] { keep(*patient, folder); });
  return patient;
}

}  // namespace insonate::ui
