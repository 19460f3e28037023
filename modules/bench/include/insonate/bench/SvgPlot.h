#pragma once

#include <string>
#include <vector>

namespace insonate {

/// A chart's axis. Logarithmic axes leave out values that are not above 0.
struct PlotAxis {
  std::string title;
  bool logarithmic = false;
  bool fromZero = false;  ///< linear axes: begin at 0 even where no value is near it
};

struct PlotPoint {
  double x = 0, y = 0;
  std::string label;  ///< written beside the mark where not empty
};

/// Marks of one color, joined in the order given. Points that are not finite are left out.
struct PlotSeries {
  std::string name;
  std::vector<PlotPoint> points;
  bool joined = true;
  bool dashed = false;
  bool marked = true;  ///< unless they lie so close that the line says it
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

/// Horizontal bars, each the sum of its parts.
struct StackedBars {
  struct Part {
    std::string name;
    std::vector<double> values;  ///< one a bar; values that are missing, not finite or below 0 count as 0
  };
  std::string title, subtitle, valueTitle;
  std::vector<std::string> bars;
  std::vector<Part> parts;
};

/// A whole SVG file: dark text on white, any text escaped. A chart without a single point keeps its frame and says so.
std::string svgOf(const LineChart& chart);
std::string svgOf(const StackedBars& chart);

}  // namespace insonate
