#include "Finite.h"
#include "Sorted.h"

#include <insonate/curriculum/Statistics.h>

#include <boost/math/distributions/normal.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace insonate {
namespace {

bool isShare(double value) {
  return value > 0 && value < 1;
}

}  // namespace

std::optional<double> meanValue(std::span<const double> values) {
  if (values.empty() || !allFinite(values)) return std::nullopt;
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  return std::isfinite(mean) ? std::optional(mean) : std::nullopt;
}

std::optional<double> standardDeviation(std::span<const double> values) {
  const auto mean = meanValue(values);
  if (!mean || values.size() < 2) return std::nullopt;
  double squares = 0;
  for (const double value : values) squares += (value - *mean) * (value - *mean);
  const double deviation = std::sqrt(squares / static_cast<double>(values.size() - 1));
  return std::isfinite(deviation) ? std::optional(deviation) : std::nullopt;
}

std::optional<double> quantile(std::span<const double> values, double share) {
  if (values.empty() || !allFinite(values) || !(share >= 0 && share <= 1)) return std::nullopt;
  return quantileOfSorted(sortedOf(values), share);
}

std::optional<double> median(std::span<const double> values) {
  return quantile(values, 0.5);
}

std::optional<Estimate> proportion(int successes, int trials, double confidence) {
  if (trials < 1 || successes < 0 || successes > trials || !isShare(confidence)) return std::nullopt;
  // Wilson: (p + z^2 / 2n +- z sqrt(p (1 - p) / n + z^2 / 4n^2)) / (1 + z^2 / n)
  const double n = trials, p = successes / n;
  const double z = boost::math::quantile(boost::math::normal(), (1 + confidence) / 2);
  const double middle = (p + z * z / (2 * n)) / (1 + z * z / n);
  const double half = z * std::sqrt(p * (1 - p) / n + z * z / (4 * n * n)) / (1 + z * z / n);
  return Estimate{p, Interval{std::max(0.0, middle - half), std::min(1.0, middle + half)}, "Wilson"};
}

std::vector<std::optional<double>> movingMean(std::span<const std::optional<double>> values, int window) {
  std::vector<std::optional<double>> means(values.size());
  if (window < 1) return means;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!values[i]) continue;
    std::vector<double> last;
    for (const auto& value : values.first(i + 1).last(std::min(i + 1, static_cast<std::size_t>(window))))
      if (value) last.push_back(*value);
    means[i] = meanValue(last);
  }
  return means;
}

std::optional<BoxPlot> boxPlotOf(std::span<const double> values) {
  if (values.empty() || !allFinite(values)) return std::nullopt;
  const std::vector<double> sorted = sortedOf(values);
  BoxPlot box;
  box.lowerQuartile = quantileOfSorted(sorted, 0.25), box.upperQuartile = quantileOfSorted(sorted, 0.75);
  box.median = quantileOfSorted(sorted, 0.5);
  const double reach = 1.5 * (box.upperQuartile - box.lowerQuartile);
  const auto isInside = [&](double value) {
    return value >= box.lowerQuartile - reach && value <= box.upperQuartile + reach;
  };
  box.lowerWhisker = *std::ranges::find_if(sorted, isInside);
  box.upperWhisker = *std::find_if(sorted.rbegin(), sorted.rend(), isInside);
  for (const double value : sorted)
    if (!isInside(value)) box.outliers.push_back(value);
  return box;
}

std::optional<double> percentileRank(std::span<const double> values, double value) {
  if (values.empty() || !allFinite(values) || !std::isfinite(value)) return std::nullopt;
  const auto below = std::ranges::count_if(values, [&](double other) { return other < value; });
  const auto equal = std::ranges::count(values, value);
  return 100 * (static_cast<double>(below) + static_cast<double>(equal) / 2) / static_cast<double>(values.size());
}

}  // namespace insonate
