#pragma once

#include <QString>

namespace insonate::ui {

/// In lines that a screen has room for, since a tooltip wraps nothing but rich text, and cut where it is endless.
QString plainToolTip(const QString& text);

}  // namespace insonate::ui
