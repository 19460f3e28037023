#pragma once

#include <QString>

namespace insonate::ui {

/// Returns a tooltip text broken into lines that fit on the screen, since Qt breaks lines of rich text only. A very
/// long text is truncated.
QString plainToolTip(const QString& text);

/// Returns a caption for a menu entry or button that shows the text: & and tabs, which Qt would interpret, are escaped,
/// and the text is shortened to one line.
QString plainCaption(const QString& text);

}  // namespace insonate::ui
