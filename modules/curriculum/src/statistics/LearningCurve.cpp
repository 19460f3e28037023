#include "Finite.h"

#include <insonate/curriculum/LearningCurve.h>

#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/tools/minima.hpp>

#include <Eigen/Dense>
#include <cmath>

namespace insonate {
namespace {

using Shape = LearningCurve::Shape;

constexpr std::size_t kFewest = 6;
constexpr int kParameters = 3;

/// How much of the gain is left at an attempt, 1 at the first.
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

Fit fitAt(Shape shape, double rate, const Eigen::VectorXd& values) {
  Eigen::MatrixX2d curve(values.size(), 2);
  for (Eigen::Index i = 0; i < values.size(); ++i) curve.row(i) << 1, left(shape, rate, static_cast<double>(i + 1));
  Fit fit{rate, curve.colPivHouseholderQr().solve(values), 0};
  fit.squares = (curve * fit.plateauAndGain - values).squaredNorm();
  return fit;
}

/// None where the best rate is the least or the greatest that is looked at: then the data are a straight line, or all
/// is learnt after the first attempt.
std::optional<Fit> bestFit(Shape shape, const Eigen::VectorXd& values) {
  constexpr int kSteps = 120;
  const auto attempts = static_cast<double>(values.size());
  const double least = std::log(shape == Shape::Power ? 0.05 : 0.5 / attempts), most = std::log(5.0);
  const auto rateOf = [&](int step) { return least + (most - least) * step / kSteps; };
  int best = 0;
  double fewest = fitAt(shape, std::exp(least), values).squares;
  for (int step = 1; step <= kSteps; ++step) {
    const double squares = fitAt(shape, std::exp(rateOf(step)), values).squares;
    if (squares < fewest) fewest = squares, best = step;
  }
  if (best == 0 || best == kSteps) return std::nullopt;
  const auto squaresAt = [&](double logRate) { return fitAt(shape, std::exp(logRate), values).squares; };
  const auto [logRate, squares] =
      boost::math::tools::brent_find_minima(squaresAt, rateOf(best - 1), rateOf(best + 1), 40);
  return fitAt(shape, std::exp(logRate), values);
}

/// F test of the curve's two further parameters against a constant, at 5 %.
bool explainsMoreThanConstant(const Fit& fit, const Eigen::VectorXd& values) {
  const double all = (values.array() - values.mean()).square().sum();
  if (!(all > 1e-20 * values.squaredNorm())) return false;
  const auto freedom = static_cast<double>(values.size() - kParameters);
  const double limit = boost::math::quantile(boost::math::fisher_f(2, freedom), 0.95);
  return (all - fit.squares) / 2 > limit * fit.squares / freedom;
}

Estimate estimateOf(double value, double variance, double t) {
  const double half = t * std::sqrt(variance);
  return {value, Interval{value - half, value + half}};
}

double studentT(int attempts, double confidence) {
  return boost::math::quantile(boost::math::students_t(attempts - kParameters), (1 + confidence) / 2);
}

std::optional<LearningCurve> curveOf(Shape shape, const Fit& fit, const Eigen::VectorXd& values) {
  Eigen::MatrixX3d jacobian(values.size(), kParameters);
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const auto attempt = static_cast<double>(i + 1);
    jacobian.row(i) << 1, left(shape, fit.rate, attempt), fit.plateauAndGain[1] * leftByRate(shape, fit.rate, attempt);
  }
  const Eigen::Matrix3d normal = jacobian.transpose() * jacobian;
  const Eigen::FullPivLU<Eigen::Matrix3d> solver(normal);
  if (!solver.isInvertible()) return std::nullopt;
  LearningCurve curve;
  curve.shape = shape;
  curve.attempts = static_cast<int>(values.size());
  curve.rate = fit.rate;
  const double variance = fit.squares / (curve.attempts - kParameters);
  curve.residual = std::sqrt(variance);
  const Eigen::Matrix3d spread = variance * solver.inverse();
  Eigen::Map<Eigen::Matrix3d>(curve.spread.data()) = spread;
  const double t = studentT(curve.attempts, 0.95);
  curve.plateau = estimateOf(fit.plateauAndGain[0], spread(0, 0), t);
  curve.gain = estimateOf(fit.plateauAndGain[1], spread(1, 1), t);
  return allFinite(curve.spread) ? std::optional(curve) : std::nullopt;
}

}  // namespace

double LearningCurve::at(double attempt) const {
  return plateau.value + gain.value * left(shape, rate, attempt);
}

Interval LearningCurve::bandAt(double attempt, double confidence) const {
  const Eigen::Vector3d slope(1, left(shape, rate, attempt), gain.value * leftByRate(shape, rate, attempt));
  const double variance = slope.dot(Eigen::Map<const Eigen::Matrix3d>(spread.data()) * slope);
  const double half = studentT(attempts, confidence) * std::sqrt(std::max(0.0, variance));
  return {at(attempt) - half, at(attempt) + half};
}

std::optional<LearningCurve> fitLearningCurve(Shape shape, std::span<const double> values) {
  if (values.size() < kFewest || !allFinite(values)) return std::nullopt;
  const Eigen::VectorXd vector =
      Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
  const auto fit = bestFit(shape, vector);
  if (!fit || !std::isfinite(fit->squares) || !explainsMoreThanConstant(*fit, vector)) return std::nullopt;
  return curveOf(shape, *fit, vector);
}

std::optional<LearningCurve> fitLearningCurve(std::span<const double> values) {
  const auto power = fitLearningCurve(Shape::Power, values), exponential = fitLearningCurve(Shape::Exponential, values);
  if (power && exponential) return power->residual <= exponential->residual ? power : exponential;
  return power ? power : exponential;
}

}  // namespace insonate
