#pragma once

#include <QColor>

namespace insonate::ui {

/// Colors of painted charts, results and reports, with the same names for the screen and for paper.
struct Ink {
  QColor ground, text, quiet;
  QColor line;  ///< rules, and bars that carry values
  QColor grid;  ///< grid lines of charts
  QColor band;  ///< ground of rows and bands
  QColor accent, good, caution, danger;
};

/// Colors of the theme.
Ink screenInk();
/// Dark on white; text has a contrast of 4.5:1 or more.
Ink paperInk();

}  // namespace insonate::ui
