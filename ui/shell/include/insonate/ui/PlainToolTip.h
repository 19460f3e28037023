#pragma once

#include <QString>

namespace insonate::ui {

/// Wraps a tooltip into lines that fit on a screen, since Qt wraps rich text only, and cuts an overlong one.
QString plainToolTip(const QString& text);

/// Makes the caption of a menu entry or button from any text: escapes & and tabs, which Qt would interpret, and
/// shortens it to one line.
QString plainCaption(const QString& text);

}  // namespace insonate::ui
