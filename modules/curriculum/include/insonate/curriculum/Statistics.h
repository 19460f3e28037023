#pragma once

#include <optional>
#include <span>
#include <vector>

/// Numbers of people and classes. Where there is nothing to tell there is no value ("n/a"): too few values, or one that
/// is not finite.
namespace insonate {

struct Interval {
  double low = 0, high = 0;
};

struct Estimate {
  double value = 0;
  std::optional<Interval> interval{};  ///< of confidence
};

/// Mean with the t interval mean +- t s / sqrt(n); without one for a single value.
std::optional<Estimate> meanOf(std::span<const double> values, double confidence = 0.95);
/// With n - 1; none for fewer than two.
std::optional<double> standardDeviation(std::span<const double> values);

/// Type 7 of Hyndman and Fan (Am Stat 1996, 50:361), linear between order statistics, as R, NumPy and spreadsheets
/// have it. `share` 0 to 1.
std::optional<double> quantile(std::span<const double> values, double share);
std::optional<double> median(std::span<const double> values);

/// A proportion with Wilson's score interval (J Am Stat Assoc 1927, 22:209).
std::optional<Estimate> proportion(int successes, int trials, double confidence = 0.95);

/// Of the last `window` values up to each; none where one of them is missing or there are not yet as many.
std::vector<std::optional<double>> movingMean(std::span<const std::optional<double>> values, int window);

/// Box plot after Tukey: quartiles (type 7), whiskers to the last value within 1.5 interquartile ranges of the box, the
/// others by themselves.
struct BoxPlot {
  double lowerWhisker = 0, lowerQuartile = 0, median = 0, upperQuartile = 0, upperWhisker = 0;
  std::vector<double> outliers{};  ///< in rising order
};
std::optional<BoxPlot> boxPlotOf(std::span<const double> values);

/// Shares of a value among others, 0 to 100: those below it and half of those that equal it.
std::optional<double> percentileRank(std::span<const double> values, double value);

}  // namespace insonate
