#pragma once

#include <insonate/views/Theme.h>

#include <QColor>
#include <QIcon>
#include <QString>

class QApplication;
class QWidget;

namespace insonate::ui {

/// Spacing between widgets, in logical pixels.
inline constexpr int kSmallGap = 4, kGap = 8, kLargeGap = 16;

/// Applies the program's dark theme: palette, font and style sheet. Call it once, after QApplication.
void applyTheme(QApplication& application);

/// Sets a widget's visual role. QLabel: "title", "heading", "quiet"; QPushButton: "primary";
/// QFrame: "panel", "rule" (a line).
void setRole(QWidget* widget, const char* role);

QColor toQColor(views::Color color);

/// Returns a one-colored icon from resources/icons, dimmed while its button is disabled; null if there is no such icon.
QIcon icon(const QString& name, views::Color color = views::theme::kText);

}  // namespace insonate::ui
