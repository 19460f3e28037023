#pragma once

#include <insonate/teaching/HeatMap.h>
#include <insonate/ui/Chart.h>

#include <QString>

namespace insonate::review {

/// A class with the heat map of its people, from heatMapOf().
struct ComparedClass {
  QString name;
  const HeatMap& heat;
};

struct ClassComparison {
  ui::ChartContents picture{};  ///< box plot with a box for each class
  QString words{};  ///< n, means with intervals, effect size and p; if there are too few values, "n/a" and the reason
};

/// Compares two classes in one of the comparable metrics of MetricCatalog::all(). Each person is one value, so that
/// people with more attempts do not count more.
ClassComparison compareClasses(const ComparedClass& first, const ComparedClass& second, std::size_t metric);

}  // namespace insonate::review
