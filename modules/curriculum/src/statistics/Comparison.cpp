#include "Finite.h"

#include <insonate/curriculum/Comparison.h>

#include <boost/math/distributions/normal.hpp>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace insonate {
namespace {

constexpr std::size_t kMostExact = 20;

/// Sum of the first group's ranks, and the sum of t^3 - t over groups of t equal values.
struct Ranks {
  double first = 0, ties = 0;
};

Ranks ranksOf(std::span<const double> first, std::span<const double> second) {
  std::vector<std::pair<double, bool>> all;
  for (const double value : first) all.emplace_back(value, true);
  for (const double value : second) all.emplace_back(value, false);
  std::ranges::sort(all);
  Ranks ranks;
  for (std::size_t begin = 0, end = 0; begin < all.size(); begin = end) {
    while (end < all.size() && all[end].first == all[begin].first) ++end;
    const auto tied = static_cast<double>(end - begin);
    const double rank = (static_cast<double>(begin + end) + 1) / 2;
    for (std::size_t i = begin; i < end; ++i) ranks.first += all[i].second ? rank : 0;
    ranks.ties += tied * tied * tied - tied;
  }
  return ranks;
}

/// Chance of a U of at most `u`, all arrangements of n values among n + m being alike. ways[k][s]: k of the values so
/// far belong to the first group, and s values of the second lie below them, in sum.
double exactTail(std::size_t n, std::size_t m, double u) {
  std::vector<std::vector<double>> ways(n + 1, std::vector<double>(n * m + 1, 0));
  ways[0][0] = 1;
  for (std::size_t place = 0; place < n + m; ++place)
    for (std::size_t k = std::min(place + 1, n); k > 0; --k) {
      if (place - (k - 1) > m) continue;
      const std::size_t below = place - (k - 1);  // values of the second group, if this is the k-th of the first
      for (std::size_t s = below; s <= n * m; ++s) ways[k][s] += ways[k - 1][s - below];
    }
  double all = 0, tail = 0;
  for (std::size_t s = 0; s <= n * m; ++s) {
    all += ways[n][s];
    if (static_cast<double>(s) <= u) tail += ways[n][s];
  }
  return tail / all;
}

double normalTail(double n, double m, double u, double ties) {
  const double all = n + m;
  const double variance = n * m / 12 * (all + 1 - ties / (all * (all - 1)));
  if (!(variance > 0)) return 1;
  const double z = std::max(0.0, std::abs(u - n * m / 2) - 0.5) / std::sqrt(variance);
  return 2 * boost::math::cdf(boost::math::complement(boost::math::normal(), z));
}

}  // namespace

std::optional<RankComparison> compareRanks(std::span<const double> first, std::span<const double> second) {
  if (first.empty() || second.empty() || !allFinite(first) || !allFinite(second)) return std::nullopt;
  const auto n = static_cast<double>(first.size()), m = static_cast<double>(second.size());
  const Ranks ranks = ranksOf(first, second);
  RankComparison comparison;
  comparison.u = ranks.first - n * (n + 1) / 2;
  comparison.superiority = comparison.u / (n * m);
  comparison.effect = 2 * comparison.superiority - 1;
  comparison.exact = ranks.ties == 0 && first.size() <= kMostExact && second.size() <= kMostExact;
  if (comparison.exact)
    comparison.p =
        std::min(1.0, 2 * exactTail(first.size(), second.size(), std::min(comparison.u, n * m - comparison.u)));
  else
    comparison.p = normalTail(n, m, comparison.u, ranks.ties);
  return comparison;
}

}  // namespace insonate
