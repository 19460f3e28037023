#include "Finite.h"

#include <insonate/curriculum/Comparison.h>

#include <boost/math/distributions/normal.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace insonate {
namespace {

constexpr std::size_t kMaxExact = 20;

struct Ranks {
  double first = 0;  ///< sum of the ranks of the first group
  double ties = 0;   ///< sum of t^3 - t over groups of t equal values
  /// Ranks of all values, doubled: the mean rank of an even number of equal values is not a whole number.
  std::vector<std::size_t> doubled{};
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
    ranks.doubled.insert(ranks.doubled.end(), end - begin, begin + end + 1);
  }
  return ranks;
}

/// Share of all choices of n of these ranks whose sum lies as far from the mean sum as `sum` does, or farther.
/// ways[k][s]: choices of k of the ranks so far that add up to s.
double exactChance(const std::vector<std::size_t>& doubledRanks, std::size_t n, double sum) {
  const std::size_t most = std::accumulate(doubledRanks.begin(), doubledRanks.end(), std::size_t{0});
  std::vector<std::vector<double>> ways(n + 1, std::vector<double>(most + 1, 0));
  ways[0][0] = 1;
  for (const std::size_t rank : doubledRanks)
    for (std::size_t k = n; k > 0; --k)
      for (std::size_t s = most; s >= rank; --s) ways[k][s] += ways[k - 1][s - rank];
  const double middle = static_cast<double>(n * (doubledRanks.size() + 1));
  const double distance = std::abs(2 * sum - middle);
  double all = 0, far = 0;
  for (std::size_t s = 0; s <= most; ++s) {
    all += ways[n][s];
    if (std::abs(static_cast<double>(s) - middle) >= distance) far += ways[n][s];
  }
  return far / all;
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
  if (std::min(first.size(), second.size()) < kFewestCompared || !allFinite(first) || !allFinite(second))
    return std::nullopt;
  const auto n = static_cast<double>(first.size()), m = static_cast<double>(second.size());
  const Ranks ranks = ranksOf(first, second);
  RankComparison comparison;
  comparison.u = ranks.first - n * (n + 1) / 2;
  comparison.superiority = comparison.u / (n * m);
  comparison.effect = 2 * comparison.superiority - 1;
  comparison.exact = first.size() <= kMaxExact && second.size() <= kMaxExact;
  comparison.p = comparison.exact ? exactChance(ranks.doubled, first.size(), ranks.first)
                                  : normalTail(n, m, comparison.u, ranks.ties);
  return comparison;
}

}  // namespace insonate
