#include "Finite.h"
#include "Sorted.h"

#include <insonate/curriculum/Statistics.h>

#include <boost/math/distributions/gamma.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <random>

namespace insonate {
namespace {

constexpr std::size_t kFewestForT = 10;
constexpr int kSamples = 10'000;

bool areWhole(std::span<const double> values, double most) {
  return std::ranges::all_of(values, [&](double v) { return v >= 0 && v <= most && v == std::floor(v); });
}

double quantileOfT(std::size_t values, double confidence) {
  const boost::math::students_t distribution(static_cast<double>(values) - 1);
  return boost::math::quantile(distribution, (1 + confidence) / 2);
}

/// Exact interval of a mean of counts. Their sum follows Poisson's distribution; the bounds are the means at which a
/// sum as small, or as large, as the observed one has the probability (1 - confidence) / 2 (Garwood 1936).
Interval poissonInterval(std::span<const double> counts, double confidence) {
  const double sum = std::accumulate(counts.begin(), counts.end(), 0.0), n = static_cast<double>(counts.size());
  const double tail = (1 - confidence) / 2;
  const double low = sum > 0 ? boost::math::quantile(boost::math::gamma_distribution<>(sum), tail) : 0;
  return {low / n, boost::math::quantile(boost::math::gamma_distribution<>(sum + 1), 1 - tail) / n};
}

/// Percentiles of means of samples with replacement. They are too narrow by sqrt((n - 1) / n) and by normal instead of
/// t quantiles: the shares are widened by both.
Interval bootstrapInterval(const std::vector<double>& sorted, double confidence) {
  const std::size_t n = sorted.size();
  std::mt19937 random(1);
  std::vector<double> means;
  means.reserve(kSamples);
  for (int sample = 0; sample < kSamples; ++sample) {
    double sum = 0;
    // Standard distributions may differ between libraries; the numbers of this engine do not.
    for (std::size_t i = 0; i < n; ++i) sum += sorted[(static_cast<std::uint64_t>(random()) * n) >> 32];
    means.push_back(sum / static_cast<double>(n));
  }
  std::ranges::sort(means);
  const double widened = std::sqrt(static_cast<double>(n) / static_cast<double>(n - 1)) * quantileOfT(n, confidence);
  const double share = boost::math::cdf(boost::math::normal(), -widened);
  // Limits rounding errors of a sum to the range of the values.
  return {std::max(sorted.front(), quantileOfSorted(means, share)),
          std::min(sorted.back(), quantileOfSorted(means, 1 - share))};
}

/// The t interval, if its assumptions hold and it stays in the range.
std::optional<Interval> tInterval(const std::vector<double>& sorted, double mean, Interval range, double confidence) {
  const bool hasTies = std::ranges::adjacent_find(sorted) != sorted.end();
  const auto deviation = standardDeviation(sorted);
  if (sorted.size() < kFewestForT || hasTies || !deviation) return std::nullopt;
  const double half =
      quantileOfT(sorted.size(), confidence) * *deviation / std::sqrt(static_cast<double>(sorted.size()));
  const Interval interval{mean - half, mean + half};
  return interval.low >= range.low && interval.high <= range.high ? std::optional(interval) : std::nullopt;
}

}  // namespace

Interval rangeOf(ValueKind kind) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  switch (kind) {
    case ValueKind::Any:
      return {-kInfinite, kInfinite};
    case ValueKind::NotNegative:
    case ValueKind::Count:
      return {0, kInfinite};
    case ValueKind::Percent:
      return {0, 100};
    case ValueKind::YesNo:
      break;
  }
  return {0, 1};
}

std::optional<Estimate> meanOf(std::span<const double> values, ValueKind kind, double confidence) {
  const auto mean = meanValue(values);
  if (!mean || !(confidence > 0 && confidence < 1)) return std::nullopt;
  constexpr double kMaxCounted = 1e9;
  if (kind == ValueKind::Count && areWhole(values, kMaxCounted))
    return Estimate{*mean, poissonInterval(values, confidence), "Poisson"};
  if (kind == ValueKind::YesNo && areWhole(values, 1))
    return proportion(static_cast<int>(std::ranges::count(values, 1.0)), static_cast<int>(values.size()), confidence);
  if (values.size() < kFewestForInterval) return Estimate{*mean, std::nullopt, "fewer than 5 values"};
  const std::vector<double> sorted = sortedOf(values);
  if (sorted.front() == sorted.back()) return Estimate{*mean, std::nullopt, "all values are equal"};
  if (const auto interval = tInterval(sorted, *mean, rangeOf(kind), confidence)) return Estimate{*mean, interval, "t"};
  return Estimate{*mean, bootstrapInterval(sorted, confidence), "bootstrap"};
}

}  // namespace insonate
