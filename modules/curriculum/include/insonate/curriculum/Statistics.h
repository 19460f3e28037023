#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

/// Print statistics of people and classes. There is no value ("n/a") if there are too few values or if one is not
/// finite.
namespace insonate {

/// Number of latest counting attempts that describe a trainee's present performance: in class lists, comparisons,
/// personal pages and the command line.
inline constexpr int kLastAttempts = 10;

struct Interval {
  double low = 0, high = 0;
};

struct Estimate {
  double value = 0;
  std::optional<Interval> interval{};  ///< confidence interval
  /// Method of the interval if there are several methods, or the reason why there is no interval: "t", "Poisson",
  /// "Wilson", "bootstrap", "fewer than 5 values", "all values are equal".
  std::string_view basis{};
};

/// Range of values that a metric can have. Intervals and learning curves stay within it.
enum class ValueKind {
  Any,          ///< any number, e.g. a distance that is negative inside
  NotNegative,  ///< e.g. a time, a distance, a force
  Percent,      ///< 0 to 100
  Count,        ///< a whole number, 0 or more
  YesNo,        ///< 0 or 1
};
/// Permitted range, with infinite ends if there is no limit.
Interval rangeOf(ValueKind kind);

inline constexpr std::size_t kFewestForInterval = 5;

std::optional<double> meanValue(std::span<const double> values);

/// Mean with an interval that lies within the kind's range:
/// - counts: exact interval of Poisson's distribution of their sum (Garwood, Biometrika 1936, 28:437), from one value
///   on
/// - yes and no: Wilson's interval, as in proportion()
/// - others: mean +- t s / sqrt(n) for at least 10 values without ties, if this interval lies within the range; else
///   percentiles of the bootstrap, widened for few values (Hesterberg, Am Stat 2015, 69:371, "expanded percentile"),
///   from 10 000 samples that are the same for the same values. No interval for fewer than kFewestForInterval values,
///   since even the range of 4 values contains the median in only 87.5 % of cases, and none if all values are equal.
/// Counts that are not whole, and shares between yes and no, are means of such values and are treated as others.
std::optional<Estimate> meanOf(std::span<const double> values, ValueKind kind, double confidence = 0.95);

/// Standard deviation with n - 1; empty for fewer than two values.
std::optional<double> standardDeviation(std::span<const double> values);

/// Quantile by type 7 of Hyndman and Fan (Am Stat 1996, 50:361): linear between order statistics, as in R, NumPy and
/// spreadsheets. `share` 0 to 1.
std::optional<double> quantile(std::span<const double> values, double share);
std::optional<double> median(std::span<const double> values);

/// A proportion with Wilson's score interval (J Am Stat Assoc 1927, 22:209).
std::optional<Estimate> proportion(int successes, int trials, double confidence = 0.95);

/// Moving mean: for each value, the mean of the existing values among the last `window` values up to it; fewer at the
/// beginning; empty if the value itself is missing. The last moving mean is thus the mean of the last attempts, as a
/// class list shows it.
std::vector<std::optional<double>> movingMean(std::span<const std::optional<double>> values, int window);

/// Box plot after Tukey: quartiles (type 7), and whiskers to the last value within 1.5 interquartile ranges of the box.
/// Values beyond the whiskers are outliers.
struct BoxPlot {
  double lowerWhisker = 0, lowerQuartile = 0, median = 0, upperQuartile = 0, upperWhisker = 0;
  std::vector<double> outliers{};  ///< rising order
};
std::optional<BoxPlot> boxPlotOf(std::span<const double> values);

/// Percentile rank of a value among others, 0 to 100: the share of values below it plus half of the share equal to it.
std::optional<double> percentileRank(std::span<const double> values, double value);

}  // namespace insonate
