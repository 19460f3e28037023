#pragma once

#include <QString>

class QWidget;

namespace insonate::ui {

/// Ask for what a hospital or another program has sent; empty when nothing was chosen. Where it lies is remembered
/// until the program ends, and written nowhere: its folders are named after patients.
QString askForSourceFolder(QWidget* window, const QString& title);
QString askForSourceFile(QWidget* window, const QString& title, const QString& filter);

}  // namespace insonate::ui
