#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

/// Statistics of people and classes. Results are empty if there are too few values or a value is not finite; the window
/// then shows "n/a".
namespace insonate {

/// Number of last attempts of a trainee from which the present performance is computed.
inline constexpr int kLastAttempts = 10;

struct Interval {
  double low = 0, high = 0;
};

struct Estimate {
  double value = 0;
  std::optional<Interval> interval{};  ///< confidence interval of `value`
  /// Method of the interval if several methods exist, or the reason why there is no interval: "t", "Poisson", "Wilson",
  /// "bootstrap", "fewer than 5 values", "all values are equal".
  std::string_view basis{};
};

/// Kind of the values of a metric, which determines their range. Confidence intervals and learning curves stay within
/// this range.
enum class ValueKind {
  Any,          ///< any number, e.g. a distance that is negative inside
  NotNegative,  ///< 0 or more, e.g. a time, a distance, a force
  Percent,      ///< 0 to 100
  Count,        ///< a whole number, 0 or more
  YesNo,        ///< 0 or 1
};
/// Returns the range of values of a kind, with infinite ends where there is no limit.
Interval rangeOf(ValueKind kind);

inline constexpr std::size_t kFewestForInterval = 5;

std::optional<double> meanValue(std::span<const double> values);

/// Returns the mean with a confidence interval that lies within the range of `kind`:
/// - counts: exact interval of Poisson's distribution of their sum (Garwood, Biometrika 1936, 28:437), even for a
///   single value
/// - yes and no: Wilson's interval, as in proportion()
/// - others: mean +- t s / sqrt(n) for at least 10 values without ties, if this interval lies within the range; else
///   percentiles of the bootstrap, widened for few values (Hesterberg, Am Stat 2015, 69:371, "expanded percentile"),
///   from 10 000 samples that are the same for the same values. There is no interval for fewer than kFewestForInterval
///   values, since even the range of 4 values contains the median in only 87.5 % of cases. There is no interval if all
///   values are equal.
/// Counts that are not whole numbers, and YesNo values between 0 and 1, are means of several attempts, and are treated
/// like other values.
std::optional<Estimate> meanOf(std::span<const double> values, ValueKind kind, double confidence = 0.95);

/// Returns the sample standard deviation (divisor n - 1); empty for fewer than two values.
std::optional<double> standardDeviation(std::span<const double> values);

/// Returns a quantile by type 7 of Hyndman and Fan (Am Stat 1996, 50:361): linear between order statistics, as in R,
/// NumPy and spreadsheets. `share` 0 to 1.
std::optional<double> quantile(std::span<const double> values, double share);
std::optional<double> median(std::span<const double> values);

/// Returns a proportion with Wilson's score interval (J Am Stat Assoc 1927, 22:209).
std::optional<Estimate> proportion(int successes, int trials, double confidence = 0.95);

/// Returns, for each value, the mean of this value and those of the previous `window` - 1 values that exist; empty for
/// a missing value.
std::vector<std::optional<double>> movingMean(std::span<const std::optional<double>> values, int window);

/// Box plot after Tukey: quartiles (type 7 as in quantile()), and whiskers that end at the outermost values within 1.5
/// interquartile ranges of the box. Values beyond the whiskers are outliers.
struct BoxPlot {
  double lowerWhisker = 0, lowerQuartile = 0, median = 0, upperQuartile = 0, upperWhisker = 0;
  std::vector<double> outliers{};  ///< values beyond the whiskers, in rising order
};
std::optional<BoxPlot> boxPlotOf(std::span<const double> values);

/// Returns the percentile rank of `value` among `values`, 0 to 100: the share of values below `value` plus half of the
/// share of values equal to `value`.
std::optional<double> percentileRank(std::span<const double> values, double value);

}  // namespace insonate
