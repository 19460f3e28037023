#pragma once

#include "AccessibleNames.h"

#include <QLabel>
#include <QString>
#include <QWidget>

namespace insonate::test {

/// Text that would be fetched and drawn, or would turn its surroundings, if it were taken for more than text.
inline const QString kHostileMark = QStringLiteral("<img src='http://192.0.2.1/x.png'>");
inline const QString kHostileText = QStringLiteral("=HYPERLINK(\"http://x\") <b>bold</b> &amp; &File %1 %n ") +
                                    kHostileMark + QStringLiteral(" \u0645\u0631\u062d\u0628\u0627");
/// As long as a file may hold, with what a name that is typed may not have.
inline QString endlessText() {
  return QStringLiteral("\u202e") + kHostileText + QStringLiteral("\n\t") + QString(10'000, QLatin1Char('W'));
}

/// Each label shows such texts as they are, and the window finds room on a small screen. How many labels do.
inline int expectPlain(QWidget& window) {
  constexpr int kSmallScreen_px = 1366;
  int seen = 0;
  for (const QLabel* label : window.findChildren<QLabel*>()) {
    if (!label->text().contains(QLatin1String("<b>bold"))) continue;
    ++seen;
    // One that was not shown yet is polished before it is.
    const_cast<QLabel*>(label)->ensurePolished();
    EXPECT_EQ(label->textFormat(), Qt::PlainText) << what(label);
  }
  EXPECT_LE(window.minimumSizeHint().width(), kSmallScreen_px);
  return seen;
}

}  // namespace insonate::test
