#pragma once

#include <QString>

class QWidget;

namespace insonate::ui {

/// Asks the user for a folder or file from a hospital or another program; returns an empty path if the user cancelled.
/// Its location is remembered until the program ends but never written to disk, since folder names may contain
/// patients' names.
QString askForSourceFolder(QWidget* window, const QString& title);
QString askForSourceFile(QWidget* window, const QString& title, const QString& filter);
/// Asks for a file, or for the folder that is selected or shown, which a button of its own takes.
QString askForSourceFileOrFolder(QWidget* window, const QString& title, const QString& filter);

}  // namespace insonate::ui
