#pragma once

#include <string>
#include <vector>

namespace insonate {

/// Axis of a chart. Logarithmic axes leave out values that are not above 0.
struct PlotAxis {
  std::string title;
  bool logarithmic = false;
  bool fromZero = false;  ///< true: a linear axis begins at 0 even if no value is near 0
};

struct PlotPoint {
  double x = 0, y = 0;
  std::string label;  ///< text beside the point's mark, or empty
};

/// Data series of a chart: points drawn as marks of one color, joined by lines in their order. Points that are not
/// finite are left out.
struct PlotSeries {
  std::string name;
  std::vector<PlotPoint> points;
  bool joined = true;
  bool dashed = false;
  bool marked = true;  ///< true: marks are drawn, unless they are very close together
};

/// A horizontal line across the chart, such as a limit.
struct PlotLevel {
  std::string name;
  double y = 0;
};

struct LineChart {
  std::string title, subtitle;
  PlotAxis x, y;
  std::vector<PlotSeries> series;
  std::vector<PlotLevel> levels;
};

/// Chart of horizontal stacked bars.
struct StackedBars {
  struct Part {
    std::string name;
    /// length of this part in each bar; values that are missing, not finite or below 0 count as 0
    std::vector<double> values;
  };
  std::string title, subtitle, valueTitle;
  std::vector<std::string> bars;
  std::vector<Part> parts;
};

/// Returns a chart as a complete SVG file: dark text on white, all text escaped. A chart without points contains a text
/// that says so.
std::string svgOf(const LineChart& chart);
std::string svgOf(const StackedBars& chart);

}  // namespace insonate
