#pragma once

#include <QString>

namespace insonate::ui {

/// In lines that a screen has room for, since a tooltip wraps nothing but rich text, and cut where it is endless.
QString plainToolTip(const QString& text);

/// For a menu's entry or a button, where & would mark a key and a tab set off another: one line, cut where it is long.
QString plainCaption(const QString& text);

}  // namespace insonate::ui
