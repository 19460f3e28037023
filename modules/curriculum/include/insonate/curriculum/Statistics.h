#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

/// Numbers of people and classes. Where there is nothing to tell there is no value ("n/a"): too few values, or one that
/// is not finite.
namespace insonate {

/// Number of latest counting attempts that describe a trainee's present performance: in class lists, comparisons,
/// personal pages and the command line.
inline constexpr int kLastAttempts = 10;

struct Interval {
  double low = 0, high = 0;
};

struct Estimate {
  double value = 0;
  std::optional<Interval> interval{};  ///< of confidence
  /// Method of the interval where there are several, or the reason why there is no interval: "t", "Poisson", "Wilson",
  /// "bootstrap", "fewer than 5 values", "all values alike".
  std::string_view basis{};
};

/// Range of values that a metric can have. Intervals and learning curves stay within it.
enum class ValueKind {
  Any,          ///< any number: a distance that is negative inside
  NotNegative,  ///< a time, a distance, a force
  Percent,      ///< 0 to 100
  Count,        ///< a whole number from 0 on
  YesNo,        ///< 0 or 1
};
/// Permitted range, with infinite ends if there is no limit.
Interval rangeOf(ValueKind kind);

inline constexpr std::size_t kFewestForInterval = 5;

std::optional<double> meanValue(std::span<const double> values);

/// Mean with an interval that lies within the kind's range:
/// - counts: exact by Poisson's distribution of their sum (Garwood, Biometrika 1936, 28:437), from one value on
/// - yes and no: Wilson's, as proportion()
/// - others: mean +- t s / sqrt(n), from 10 values on without ties, where it stays in the range;
///   else the bootstrap's percentiles, widened for few values (Hesterberg, Am Stat 2015, 69:371, "expanded
///   percentile"), of 10 000 samples that are the same for the same values. None for fewer than kFewestForInterval:
///   even from the least to the greatest of 4 values it holds the median in 87.5 % only. None where all are alike.
/// Counts that are not whole, and shares between yes and no, are means of such values and belong to the others.
std::optional<Estimate> meanOf(std::span<const double> values, ValueKind kind, double confidence = 0.95);

/// Standard deviation with n - 1; empty for fewer than two values.
std::optional<double> standardDeviation(std::span<const double> values);

/// Type 7 of Hyndman and Fan (Am Stat 1996, 50:361), linear between order statistics, as R, NumPy and spreadsheets
/// have it. `share` 0 to 1.
std::optional<double> quantile(std::span<const double> values, double share);
std::optional<double> median(std::span<const double> values);

/// A proportion with Wilson's score interval (J Am Stat Assoc 1927, 22:209).
std::optional<Estimate> proportion(int successes, int trials, double confidence = 0.95);

/// Mean of the existing values among the last `window`, after each value; fewer at the beginning; empty where the
/// value itself is missing. The last one is thus the mean of the last attempts, as a class list shows it.
std::vector<std::optional<double>> movingMean(std::span<const std::optional<double>> values, int window);

/// Box plot after Tukey: quartiles (type 7), whiskers to the last value within 1.5 interquartile ranges of the box, the
/// others by themselves.
struct BoxPlot {
  double lowerWhisker = 0, lowerQuartile = 0, median = 0, upperQuartile = 0, upperWhisker = 0;
  std::vector<double> outliers{};  ///< in rising order
};
std::optional<BoxPlot> boxPlotOf(std::span<const double> values);

/// Percentile rank of a value among others, 0 to 100: those below it and half of those equal to it.
std::optional<double> percentileRank(std::span<const double> values, double value);

}  // namespace insonate
