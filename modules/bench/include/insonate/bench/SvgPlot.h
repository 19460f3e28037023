#pragma once

#include <string>
#include <vector>

namespace insonate {

/// Axis of a chart. Logarithmic axes leave out values that are not above 0.
struct PlotAxis {
  std::string title;
  bool logarithmic = false;
  bool fromZero = false;  ///< a linear axis begins at 0 even if no value is near 0
};

struct PlotPoint {
  double x = 0, y = 0;
  std::string label;  ///< text beside the mark; may be empty
};

/// Marks of one color, joined in their order. Points that are not finite are left out.
struct PlotSeries {
  std::string name;
  std::vector<PlotPoint> points;
  bool joined = true;
  bool dashed = false;
  bool marked = true;  ///< draw marks, unless they are so close that the line suffices
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

/// Horizontal bars, each the sum of its segments.
struct StackedBars {
  struct Part {
    std::string name;
    std::vector<double> values;  ///< one value per bar; values that are missing, not finite or below 0 count as 0
  };
  std::string title, subtitle, valueTitle;
  std::vector<std::string> bars;
  std::vector<Part> parts;
};

/// Returns a complete SVG file: dark text on white, all text escaped. A chart without points keeps its frame and says
/// that it has no data.
std::string svgOf(const LineChart& chart);
std::string svgOf(const StackedBars& chart);

}  // namespace insonate
