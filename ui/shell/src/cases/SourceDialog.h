#pragma once

#include <QString>

class QWidget;

namespace insonate::ui {

/// Asks the user for a folder that came from a hospital or another program; returns an empty path if the user
/// cancelled. The location of the folder is remembered until the program ends but never written to disk, since folder
/// names may contain patients' names.
QString askForSourceFolder(QWidget* window, const QString& title);
QString askForSourceFile(QWidget* window, const QString& title, const QString& filter);
/// Asks for a file or a folder. The dialog has a separate button that chooses the selected or shown folder.
QString askForSourceFileOrFolder(QWidget* window, const QString& title, const QString& filter);

}  // namespace insonate::ui
