#include "SourceDialog.h"

#include <insonate/ui/RecentCases.h>

#include <QDir>
#include <QFileDialog>
#include <QSettings>

namespace insonate::ui {
namespace {

QString& lastPlace() {
  static QString place;
  return place;
}

QString startFolder() {
  if (!lastPlace().isEmpty()) return lastPlace();
  const auto cases = recentCases();
  return cases.empty() ? QDir::homePath() : QFileInfo(cases.front().folder).absolutePath();
}

/// Qt's own dialogs store the folders that they have shown.
QString keptInMindAlone(const QString& chosen) {
  QSettings toolkit(QSettings::UserScope, QStringLiteral("QtProject"));
  for (const char* place : {"FileDialog/history", "FileDialog/lastVisited"}) toolkit.remove(QLatin1String(place));
  if (!chosen.isEmpty()) lastPlace() = QFileInfo(chosen).absolutePath();
  return chosen;
}

}  // namespace

QString askForSourceFolder(QWidget* window, const QString& title) {
  return keptInMindAlone(QFileDialog::getExistingDirectory(window, title, startFolder()));
}

QString askForSourceFile(QWidget* window, const QString& title, const QString& filter) {
  return keptInMindAlone(QFileDialog::getOpenFileName(window, title, startFolder(), filter));
}

}  // namespace insonate::ui
