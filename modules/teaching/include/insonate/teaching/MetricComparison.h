#pragma once

#include <insonate/curriculum/Comparison.h>
#include <insonate/curriculum/MetricMeaning.h>
#include <insonate/curriculum/Statistics.h>
#include <insonate/teaching/HeatMap.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace insonate {

/// Values of a class in one metric: the mean of each person's last attempts (HeatCell::value), one value for each
/// person who has one, so that people with more attempts do not count more.
std::vector<double> valuesOf(const HeatMap& people, std::size_t metric);

/// Two classes in one metric.
struct MetricComparison {
  std::vector<double> first{}, second{};                  ///< valuesOf() each class
  std::optional<Estimate> meanOfFirst{}, meanOfSecond{};  ///< empty: the class has no values
  std::optional<RankComparison> ranks{};                  ///< empty: a class has fewer than kFewestCompared values
  int inBoth = 0;  ///< number of people with values in both classes; the p-value counts them as different people
};

/// Compares two classes in the metric MetricCatalog::all()[metric].
MetricComparison compareInMetric(const HeatMap& first, const HeatMap& second, std::size_t metric);

/// Place of one person among the other people of a class, in a metric in which lower or higher values are better.
struct PlaceInClass {
  int others = 0;  ///< number of the other people
  int worse = 0;   ///< number of others with a worse value
  int equal = 0;   ///< number of others with the same value
};

/// Compares the value `own`, which must be one of `all`, with the other values. Lower values count as better only if
/// meaning.better says so.
PlaceInClass placeAmong(const std::vector<double>& all, double own, const MetricMeaning& meaning);

}  // namespace insonate
