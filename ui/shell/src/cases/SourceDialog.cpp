#include "SourceDialog.h"

#include <insonate/ui/RecentCases.h>

#include <QDir>
#include <QFileDialog>

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

/// Only until the program ends: folders of hospitals are named after patients.
QString remembered(const QString& chosen) {
  if (!chosen.isEmpty()) lastPlace() = QFileInfo(chosen).absolutePath();
  return chosen;
}

}  // namespace

QString askForSourceFolder(QWidget* window, const QString& title) {
  return remembered(QFileDialog::getExistingDirectory(window, title, startFolder()));
}

QString askForSourceFile(QWidget* window, const QString& title, const QString& filter) {
  return remembered(QFileDialog::getOpenFileName(window, title, startFolder(), filter));
}

}  // namespace insonate::ui
