#pragma once

#include <insonate/views/Theme.h>

#include <QColor>
#include <QIcon>
#include <QString>

class QApplication;
class QWidget;

namespace insonate::ui {

/// Distances in the window, in logical pixels.
inline constexpr int kSmallGap = 4, kGap = 8, kLargeGap = 16;

/// One calm dark look: palette, font and style sheet. Call it once, after QApplication.
void applyTheme(QApplication& application);

/// Sets a widget's visual role before it is shown. QLabel: "title", "heading", "quiet"; QPushButton: "primary";
/// QFrame: "panel", "rule" (a line).
void setRole(QWidget* widget, const char* role);

QColor colour(views::Colour colour);

/// A one-colored icon of resources/icons, dimmed while its button is disabled. Null if no icon has the name.
QIcon icon(const QString& name, views::Colour colour = views::theme::kText);

}  // namespace insonate::ui
