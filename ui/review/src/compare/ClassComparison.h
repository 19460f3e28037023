#pragma once

#include "../class/HeatMap.h"

#include <insonate/ui/Chart.h>

#include <QString>

namespace insonate::review {

/// A class with the means of its people, as heatMapOf() gives them.
struct ComparedClass {
  QString name;
  const HeatMap& heat;
};

struct ClassComparison {
  ui::ChartPicture picture{};  ///< a box for each class
  QString words{};             ///< n, means with their intervals, effect size and p; "n/a" and why where too few
};

/// Two classes in one metric of MetricBook::all() that can be compared; a person is one value, so that who practices
/// more does not count for more.
ClassComparison compareClasses(const ComparedClass& first, const ComparedClass& second, std::size_t metric);

}  // namespace insonate::review
