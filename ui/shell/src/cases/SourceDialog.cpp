#include "SourceDialog.h"

#include <insonate/ui/RecentCases.h>

#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QPushButton>

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

QString askForSourceFileOrFolder(QWidget* window, const QString& title, const QString& filter) {
  QFileDialog dialog(window, title, startFolder(), filter);
  dialog.setFileMode(QFileDialog::ExistingFile);
  dialog.setOption(QFileDialog::DontUseNativeDialog);  // takes no button of ours
  QString folder;
  auto* takeFolder = new QPushButton(QFileDialog::tr("Import Folder"));
  takeFolder->setObjectName(QStringLiteral("importFolder"));
  takeFolder->setToolTip(
      QFileDialog::tr("Imports the selected folder, or the folder shown if none is selected; subfolders are included"));
  takeFolder->setAutoDefault(false);
  dialog.findChild<QDialogButtonBox*>()->addButton(takeFolder, QDialogButtonBox::ActionRole);
  QObject::connect(takeFolder, &QPushButton::clicked, &dialog, [&] {
    const QStringList selected = dialog.selectedFiles();
    const bool isFolder = selected.size() == 1 && QFileInfo(selected.first()).isDir();
    folder = isFolder ? selected.first() : dialog.directory().absolutePath();
    dialog.reject();
  });
  const bool isFile = dialog.exec() == QDialog::Accepted && !dialog.selectedFiles().isEmpty();
  return remembered(isFile ? dialog.selectedFiles().first() : folder);
}

}  // namespace insonate::ui
