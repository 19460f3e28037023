#pragma once

#include <insonate/curriculum/Statistics.h>

#include <array>
#include <optional>
#include <span>

namespace insonate {

/// A metric over a person's attempts, 1 being the first.
struct LearningCurve {
  enum class Shape {
    Power,        ///< plateau + gain n^-rate
    Exponential,  ///< plateau + gain exp(-rate (n - 1))
  };

  Shape shape = Shape::Power;
  Estimate plateau{};                        ///< where practice leads
  Estimate gain{};                           ///< how far the first attempt is from it; positive where values fall
  double rate = 0;                           ///< per attempt, or the power; above 0
  double residual = 0;                       ///< standard deviation about the curve
  int attempts = 0;                          ///< it was fitted to
  Interval range = rangeOf(ValueKind::Any);  ///< of the metric; curve, plateau's interval and band stay within it
  std::array<double, 9> spread{};            ///< covariance of plateau, gain and rate, row by row

  /// Value of the curve at an attempt; the first is 1.
  double at(double attempt) const;
  /// Confidence interval of the curve there (delta method, t with attempts - 3 degrees of freedom).
  Interval bandAt(double attempt, double confidence = 0.95) const;
};

/// Fits a curve by least squares to the values of attempts 1, 2, 3 and so on; an attempt without a value keeps its
/// number. Empty if the data cannot distinguish the curve from no learning or from endless learning: fewer than 6
/// values, a non-finite value, a rate at the limit of what that many attempts can show, squares that an F test at 5 %
/// does not distinguish from those about the mean, or a plateau outside of the kind's range.
std::optional<LearningCurve> fitLearningCurve(LearningCurve::Shape shape, std::span<const std::optional<double>> values,
                                              ValueKind kind = ValueKind::Any);
/// Fits both shapes and returns the better fit.
std::optional<LearningCurve> fitLearningCurve(std::span<const std::optional<double>> values,
                                              ValueKind kind = ValueKind::Any);

}  // namespace insonate
