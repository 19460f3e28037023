#pragma once

#include "page/Markup.h"

#include <optional>
#include <string>
#include <vector>

namespace insonate::web {

/// Values by attempt number. They are shown as a chart (SVG), and as a table below the chart for screen readers and
/// text browsers.
struct AttemptChart {
  enum class Mark { Passed, Failed, Other };
  struct Point {
    double value = 0;
    Mark mark = Mark::Other;
  };
  std::string title{};                         ///< caption: "Points at Textbook neck"
  std::string unit{};                          ///< unit of the values, or empty
  std::vector<std::optional<Point>> points{};  ///< value of each attempt, from number 1; empty if an attempt has no
                                               ///< value
  std::optional<double> limit{};               ///< a horizontal line, such as the limit of LC-CUSUM
  std::string limitName{};                     ///< name of the horizontal line
};

/// Returns the chart; if there are no values, a sentence.
Markup chart(const AttemptChart& values);

/// Groups of values, each as a box plot (boxPlotOf()) with a dot for each value beside the box. The numbers are also in
/// a table below the chart.
struct BoxChart {
  struct Group {
    std::string name{};
    std::vector<double> values{};
    std::optional<double>
        marked{};  ///< a value that is drawn as a cross instead of a dot: that of the person of the page
  };
  std::string title{};
  std::string unit{};  ///< unit of the values, or empty
  std::vector<Group> groups{};
};

/// Returns the chart; if no group has values, a sentence.
Markup drawBoxes(const BoxChart& contents);

}  // namespace insonate::web
