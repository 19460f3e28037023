#pragma once

#include <insonate/ui/Chart.h>
#include <insonate/ui/Ink.h>

class QwtPlot;

namespace insonate::ui {

/// Replaces the contents of a plot by the contents of a chart.
void fillPlot(QwtPlot& plot, const ChartContents& picture, const Ink& ink);

}  // namespace insonate::ui
