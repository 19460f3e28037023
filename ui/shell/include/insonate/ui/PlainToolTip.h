#pragma once

#include <QString>

namespace insonate::ui {

/// Wraps a tooltip into lines that fit on a screen, since Qt wraps rich text only, and cuts an endless one.
QString plainToolTip(const QString& text);

/// Caption of a menu's entry or a button, where & would mark a key and a tab separate another caption: one line, cut
/// if it is long.
QString plainCaption(const QString& text);

}  // namespace insonate::ui
