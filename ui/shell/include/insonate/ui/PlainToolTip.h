#pragma once

#include <QString>

namespace insonate::ui {

/// A tooltip wraps where it is rich text; what stands in it is not: names are shown as they are.
inline QString plainToolTip(const QString& text) {
  return text.isEmpty()
             ? text
             : QStringLiteral("<p>%1</p>").arg(text.toHtmlEscaped().replace(QLatin1Char('\n'), QStringLiteral("<br>")));
}

}  // namespace insonate::ui
