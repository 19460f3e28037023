#pragma once

#include <insonate/ui/Chart.h>

#include <QColor>

class QwtPlot;

namespace insonate::ui {

/// Colors of a chart, for the screen or for paper.
struct ChartInk {
  QColor ground, line, text, quiet, accent, good, caution, danger;

  QColor of(ChartPicture::Tone tone) const;
};
ChartInk screenChartInk();
ChartInk paperChartInk();

/// Replaces the contents of a plot by a chart's.
void fillPlot(QwtPlot& plot, const ChartPicture& picture, const ChartInk& ink);

}  // namespace insonate::ui
