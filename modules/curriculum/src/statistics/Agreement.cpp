#include "Finite.h"

#include <insonate/curriculum/Agreement.h>

#include <boost/math/distributions/fisher_f.hpp>

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

constexpr int kMaxGrades = 1000;
constexpr double kMinFreedom = 0.1;

/// Weighted difference of two grades; 0 for equal grades.
double difference(int a, int b, KappaWeights weights) {
  const double steps = std::abs(a - b);
  if (weights == KappaWeights::Linear) return steps;
  return weights == KappaWeights::Quadratic ? steps * steps : steps > 0;
}

/// Mean squares of a table of subjects and raters.
struct MeanSquares {
  double subjects = 0, raters = 0, error = 0;
};

MeanSquares meanSquaresOf(const std::vector<std::vector<double>>& ratings) {
  const auto n = static_cast<double>(ratings.size()), k = static_cast<double>(ratings.front().size());
  std::vector<double> subjectMeans, raterMeans(ratings.front().size(), 0);
  double mean = 0;
  for (const std::vector<double>& row : ratings) {
    double sum = 0;
    for (std::size_t j = 0; j < row.size(); ++j) sum += row[j], raterMeans[j] += row[j] / n;
    subjectMeans.push_back(sum / k);
    mean += sum / (n * k);
  }
  MeanSquares squares;
  for (const double m : subjectMeans) squares.subjects += k * (m - mean) * (m - mean) / (n - 1);
  for (const double m : raterMeans) squares.raters += n * (m - mean) * (m - mean) / (k - 1);
  for (std::size_t i = 0; i < ratings.size(); ++i)
    for (std::size_t j = 0; j < raterMeans.size(); ++j) {
      const double rest = ratings[i][j] - subjectMeans[i] - raterMeans[j] + mean;
      squares.error += rest * rest / ((n - 1) * (k - 1));
    }
  // Rounding errors in sums of squares that are 0 do not count as differences between subjects or raters.
  double all = 0;
  for (const std::vector<double>& row : ratings)
    for (const double rating : row) all += rating * rating;
  for (double* square : {&squares.subjects, &squares.raters, &squares.error})
    if (*square < 1e-20 * all) *square = 0;
  return squares;
}

/// Shrout and Fleiss 1979, page 424.
std::optional<Interval> intervalOf(double icc, const MeanSquares& squares, double n, double k, double confidence) {
  if (!(squares.error > 0 && squares.subjects > 0)) return std::nullopt;
  const double fRaters = squares.raters / squares.error;
  const double a = k * icc * fRaters, b = n * (1 + (k - 1) * icc) - k * icc;
  const double freedom = (k - 1) * (n - 1) * (a + b) * (a + b) / ((n - 1) * a * a + b * b);
  // Far below one degree of freedom, quantiles of F overflow, and an interval has no information.
  if (!(freedom >= kMinFreedom) || !std::isfinite(freedom)) return std::nullopt;
  const double share = (1 + confidence) / 2;
  const double upper = boost::math::quantile(boost::math::fisher_f(n - 1, freedom), share);
  const double lower = boost::math::quantile(boost::math::fisher_f(freedom, n - 1), share);
  const double other = k * squares.raters + (k * n - k - n) * squares.error;
  return Interval{n * (squares.subjects - upper * squares.error) / (upper * other + n * squares.subjects),
                  n * (lower * squares.subjects - squares.error) / (other + n * lower * squares.subjects)};
}

}  // namespace

std::optional<double> agreement(std::span<const int> first, std::span<const int> second) {
  if (first.empty() || first.size() != second.size()) return std::nullopt;
  double alike = 0;
  for (std::size_t i = 0; i < first.size(); ++i) alike += first[i] == second[i];
  return alike / static_cast<double>(first.size());
}

std::optional<double> cohenKappa(std::span<const int> first, std::span<const int> second, int grades,
                                 KappaWeights weights) {
  if (first.empty() || first.size() != second.size() || grades < 1 || grades > kMaxGrades) return std::nullopt;
  const auto isGrade = [&](int grade) { return grade >= 0 && grade < grades; };
  if (!std::ranges::all_of(first, isGrade) || !std::ranges::all_of(second, isGrade)) return std::nullopt;
  const auto pairs = static_cast<double>(first.size());
  double seen = 0;
  std::vector<double> ofFirst(static_cast<std::size_t>(grades), 0), ofSecond(ofFirst);
  for (std::size_t i = 0; i < first.size(); ++i) {
    seen += difference(first[i], second[i], weights) / pairs;
    ofFirst[static_cast<std::size_t>(first[i])] += 1 / pairs;
    ofSecond[static_cast<std::size_t>(second[i])] += 1 / pairs;
  }
  double expected = 0;
  for (int a = 0; a < grades; ++a)
    for (int b = 0; b < grades; ++b)
      expected +=
          difference(a, b, weights) * ofFirst[static_cast<std::size_t>(a)] * ofSecond[static_cast<std::size_t>(b)];
  return expected > 0 ? std::optional(1 - seen / expected) : std::nullopt;
}

std::optional<Estimate> intraclassCorrelation(const std::vector<std::vector<double>>& ratings, double confidence) {
  if (ratings.size() < 2 || ratings.front().size() < 2 || !(confidence > 0 && confidence < 1)) return std::nullopt;
  for (const std::vector<double>& row : ratings)
    if (row.size() != ratings.front().size() || !allFinite(row)) return std::nullopt;
  const auto n = static_cast<double>(ratings.size()), k = static_cast<double>(ratings.front().size());
  const MeanSquares squares = meanSquaresOf(ratings);
  const double all = squares.subjects + (k - 1) * squares.error + k * (squares.raters - squares.error) / n;
  if (!std::isfinite(all) || !(all > 0)) return std::nullopt;
  const double icc = (squares.subjects - squares.error) / all;
  if (ratings.size() < kFewestForInterval) return Estimate{icc, std::nullopt, "fewer than 5 values"};
  return Estimate{icc, intervalOf(icc, squares, n, k, confidence)};
}

}  // namespace insonate
