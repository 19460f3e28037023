#pragma once

#include <insonate/curriculum/Statistics.h>

#include <array>
#include <optional>
#include <span>

namespace insonate {

/// Curve fitted to a metric over a person's attempts; the first attempt is number 1.
struct LearningCurve {
  enum class Shape {
    Power,        ///< power law of the attempt number n: plateau + gain n^-rate
    Exponential,  ///< exponential in the attempt number n: plateau + gain exp(-rate (n - 1))
  };

  Shape shape = Shape::Power;
  Estimate plateau{};   ///< value that the curve approaches with practice
  Estimate gain{};      ///< value at the first attempt minus plateau; positive if values fall with practice
  double rate = 0;      ///< learning rate per attempt (exponential), or exponent (power); above 0
  double residual = 0;  ///< standard deviation of the values about the curve
  int attempts = 0;     ///< number of attempts to which the curve was fitted
  /// Permitted range of the metric; the curve and its confidence intervals stay within it.
  Interval range = rangeOf(ValueKind::Any);
  std::array<double, 9> spread{};  ///< covariance matrix of plateau, gain and rate, row by row

  /// Returns the curve's value at an attempt; the first attempt is 1.
  double at(double attempt) const;
  /// Returns the confidence interval of the curve at an attempt (delta method; t distribution with `attempts` - 3
  /// degrees of freedom).
  Interval bandAt(double attempt, double confidence = 0.95) const;
};

/// Fits a curve by least squares to the values of attempts 1, 2, 3 and so on; an attempt without a value keeps its
/// number. Empty if the values do not determine a learning curve: if there are fewer than 6 values, if a value is not
/// finite, if the fitted rate is at the end of the range that can be determined from this number of attempts, if the
/// fit is not significantly better than the mean (F test, 5 %), or if the plateau is outside the range of `kind`.
std::optional<LearningCurve> fitLearningCurve(LearningCurve::Shape shape, std::span<const std::optional<double>> values,
                                              ValueKind kind = ValueKind::Any);
/// Fits a power law and an exponential, and returns the better fit.
std::optional<LearningCurve> fitLearningCurve(std::span<const std::optional<double>> values,
                                              ValueKind kind = ValueKind::Any);

}  // namespace insonate
