#include "Finite.h"

#include <insonate/curriculum/LearningCurve.h>

#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/tools/minima.hpp>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

namespace insonate {
namespace {

using Shape = LearningCurve::Shape;

constexpr Eigen::Index kFewest = 6;
constexpr int kParameters = 3;

/// Share of the gain that remains at an attempt; 1 at the first.
double left(Shape shape, double rate, double attempt) {
  return shape == Shape::Power ? std::pow(attempt, -rate) : std::exp(-rate * (attempt - 1));
}

double leftByRate(Shape shape, double rate, double attempt) {
  return left(shape, rate, attempt) * (shape == Shape::Power ? -std::log(attempt) : 1 - attempt);
}

/// For a given rate the curve is linear in plateau and gain, so that only the rate is searched (Golub and Pereyra, SIAM
/// J Numer Anal 1973, 10:413).
struct Fit {
  double rate = 0;
  Eigen::Vector2d plateauAndGain;
  double squares = 0;
};

/// Values with the numbers of their attempts.
struct Series {
  Eigen::VectorXd attempts, values;
};

Series seriesOf(std::span<const std::optional<double>> values) {
  std::vector<double> attempts, told;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (values[i]) attempts.push_back(static_cast<double>(i + 1)), told.push_back(*values[i]);
  const auto size = static_cast<Eigen::Index>(told.size());
  return {Eigen::Map<const Eigen::VectorXd>(attempts.data(), size),
          Eigen::Map<const Eigen::VectorXd>(told.data(), size)};
}

Fit fitAt(Shape shape, double rate, const Series& series) {
  Eigen::MatrixX2d curve(series.values.size(), 2);
  for (Eigen::Index i = 0; i < curve.rows(); ++i) curve.row(i) << 1, left(shape, rate, series.attempts[i]);
  Fit fit{rate, curve.colPivHouseholderQr().solve(series.values), 0};
  fit.squares = (curve * fit.plateauAndGain - series.values).squaredNorm();
  return fit;
}

/// None if the best rate is at the limits of the search: then the data are a straight line, or the first attempt has
/// all the learning.
std::optional<Fit> bestFit(Shape shape, const Series& series) {
  constexpr int kSteps = 120;
  const double attempts = series.attempts[series.attempts.size() - 1];
  const double least = std::log(shape == Shape::Power ? 0.05 : 0.5 / attempts), most = std::log(5.0);
  const auto rateOf = [&](int step) { return least + (most - least) * step / kSteps; };
  int best = 0;
  double fewest = fitAt(shape, std::exp(least), series).squares;
  for (int step = 1; step <= kSteps; ++step) {
    const double squares = fitAt(shape, std::exp(rateOf(step)), series).squares;
    if (squares < fewest) fewest = squares, best = step;
  }
  if (best == 0 || best == kSteps) return std::nullopt;
  const auto squaresAt = [&](double logRate) { return fitAt(shape, std::exp(logRate), series).squares; };
  const auto [logRate, squares] =
      boost::math::tools::brent_find_minima(squaresAt, rateOf(best - 1), rateOf(best + 1), 40);
  return fitAt(shape, std::exp(logRate), series);
}

/// F test of the curve's two additional parameters against a constant, at 5 %.
bool explainsMoreThanConstant(const Fit& fit, const Eigen::VectorXd& values) {
  const double all = (values.array() - values.mean()).square().sum();
  if (!(all > 1e-20 * values.squaredNorm())) return false;
  const auto freedom = static_cast<double>(values.size() - kParameters);
  const double limit = boost::math::quantile(boost::math::fisher_f(2, freedom), 0.95);
  return (all - fit.squares) / 2 > limit * fit.squares / freedom;
}

Interval within(Interval range, Interval interval) {
  return {std::clamp(interval.low, range.low, range.high), std::clamp(interval.high, range.low, range.high)};
}

Interval around(double value, double variance, double t) {
  const double half = t * std::sqrt(variance);
  return {value - half, value + half};
}

double studentT(int attempts, double confidence) {
  return boost::math::quantile(boost::math::students_t(attempts - kParameters), (1 + confidence) / 2);
}

std::optional<LearningCurve> curveOf(Shape shape, const Fit& fit, const Series& series, Interval range) {
  Eigen::MatrixX3d jacobian(series.values.size(), kParameters);
  for (Eigen::Index i = 0; i < jacobian.rows(); ++i) {
    const double attempt = series.attempts[i];
    jacobian.row(i) << 1, left(shape, fit.rate, attempt), fit.plateauAndGain[1] * leftByRate(shape, fit.rate, attempt);
  }
  const Eigen::Matrix3d normal = jacobian.transpose() * jacobian;
  const Eigen::FullPivLU<Eigen::Matrix3d> solver(normal);
  if (!solver.isInvertible()) return std::nullopt;
  LearningCurve curve;
  curve.shape = shape;
  curve.attempts = static_cast<int>(series.values.size());
  curve.range = range;
  curve.rate = fit.rate;
  const double variance = fit.squares / (curve.attempts - kParameters);
  curve.residual = std::sqrt(variance);
  const Eigen::Matrix3d spread = variance * solver.inverse();
  Eigen::Map<Eigen::Matrix3d>(curve.spread.data()) = spread;
  const double t = studentT(curve.attempts, 0.95);
  const double plateau = fit.plateauAndGain[0], gain = fit.plateauAndGain[1];
  // The true plateau lies in the range of the metric, so that cutting the interval to this range does not reduce its
  // confidence.
  curve.plateau = {plateau, within(range, around(plateau, spread(0, 0), t))};
  curve.gain = {gain, around(gain, spread(1, 1), t)};
  return allFinite(curve.spread) ? std::optional(curve) : std::nullopt;
}

}  // namespace

double LearningCurve::at(double attempt) const {
  return std::clamp(plateau.value + gain.value * left(shape, rate, attempt), range.low, range.high);
}

Interval LearningCurve::bandAt(double attempt, double confidence) const {
  const Eigen::Vector3d slope(1, left(shape, rate, attempt), gain.value * leftByRate(shape, rate, attempt));
  const double variance = slope.dot(Eigen::Map<const Eigen::Matrix3d>(spread.data()) * slope);
  const double value = plateau.value + gain.value * left(shape, rate, attempt);
  return within(range, around(value, std::max(0.0, variance), studentT(attempts, confidence)));
}

std::optional<LearningCurve> fitLearningCurve(Shape shape, std::span<const std::optional<double>> values,
                                              ValueKind kind) {
  const Series series = seriesOf(values);
  const bool isFinite = series.values.allFinite();
  if (series.values.size() < kFewest || !isFinite) return std::nullopt;
  const auto fit = bestFit(shape, series);
  if (!fit || !std::isfinite(fit->squares) || !explainsMoreThanConstant(*fit, series.values)) return std::nullopt;
  const Interval range = rangeOf(kind);
  const double plateau = fit->plateauAndGain[0];
  return plateau >= range.low && plateau <= range.high ? curveOf(shape, *fit, series, range) : std::nullopt;
}

std::optional<LearningCurve> fitLearningCurve(std::span<const std::optional<double>> values, ValueKind kind) {
  const auto power = fitLearningCurve(Shape::Power, values, kind),
             exponential = fitLearningCurve(Shape::Exponential, values, kind);
  if (power && exponential) return power->residual <= exponential->residual ? power : exponential;
  return power ? power : exponential;
}

}  // namespace insonate
