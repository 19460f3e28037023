#pragma once

#include <QColor>

namespace insonate::ui {

/// Colors of painted charts, results and reports. The members are the same for the screen and for paper.
struct Ink {
  QColor ground, text, quiet;
  QColor line;  ///< separator lines, and bars that represent values
  QColor grid;  ///< grid lines of charts
  QColor band;  ///< background of rows and bands
  QColor accent, good, caution, danger;
};

/// Returns the colors for the screen, taken from the theme.
Ink screenInk();
/// Returns the colors for paper, dark on white. Text has a contrast of at least 4.5:1.
Ink paperInk();

}  // namespace insonate::ui
