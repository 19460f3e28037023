#include <insonate/teaching/MetricCatalog.h>
#include <insonate/teaching/MetricComparison.h>

#include <algorithm>

namespace insonate {
namespace {

/// A person's mean of counts is not a count.
ValueKind kindOfMeans(const MetricMeaning& meaning) {
  return meaning.kind == ValueKind::Count ? ValueKind::NotNegative : meaning.kind;
}

}  // namespace

std::vector<double> valuesOf(const HeatMap& people, std::size_t metric) {
  std::vector<double> values;
  for (const auto& [person, row] : people)
    if (row[metric].value) values.push_back(*row[metric].value);
  return values;
}

MetricComparison compareInMetric(const HeatMap& first, const HeatMap& second, std::size_t metric) {
  MetricComparison comparison{.first = valuesOf(first, metric), .second = valuesOf(second, metric)};
  const ValueKind kind = kindOfMeans(MetricCatalog::instance().all()[metric]);
  comparison.meanOfFirst = meanOf(comparison.first, kind);
  comparison.meanOfSecond = meanOf(comparison.second, kind);
  comparison.ranks = compareRanks(comparison.first, comparison.second);
  comparison.inBoth = static_cast<int>(std::ranges::count_if(first, [&](const auto& person) {
    const auto there = second.find(person.first);
    return there != second.end() && person.second[metric].value && there->second[metric].value;
  }));
  return comparison;
}

PlaceInClass placeAmong(const std::vector<double>& all, double own, const MetricMeaning& meaning) {
  const bool isLowerBetter = meaning.better == MetricMeaning::Better::Lower;
  PlaceInClass place{.others = static_cast<int>(all.size()) - 1};
  place.worse =
      static_cast<int>(std::ranges::count_if(all, [&](double one) { return isLowerBetter ? one > own : one < own; }));
  place.equal = static_cast<int>(std::ranges::count(all, own)) - 1;
  return place;
}

}  // namespace insonate
