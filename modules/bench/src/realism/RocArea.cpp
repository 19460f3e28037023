#include <insonate/bench/RocArea.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace insonate {
namespace {

constexpr double kNormal95 = 1.959964;

double beats(double a, double b) {
  return a > b ? 1 : a == b ? 0.5 : 0;
}

/// The area with the variance of DeLong; a negative variance means that there is none.
struct Components {
  double area = 0.5, variance = -1;
};

double varianceOf(const std::vector<double>& values, double mean) {
  double sum = 0;
  for (const double v : values) sum += (v - mean) * (v - mean);
  return sum / double(values.size() - 1);
}

Components componentsOf(std::span<const double> positive, std::span<const double> negative) {
  if (positive.empty() || negative.empty()) return {};
  std::vector<double> ofPositive(positive.size()), ofNegative(negative.size());
  double sum = 0;
  for (std::size_t i = 0; i < positive.size(); ++i)
    for (std::size_t j = 0; j < negative.size(); ++j) {
      const double won = beats(positive[i], negative[j]);
      sum += won;
      ofPositive[i] += won / double(negative.size()), ofNegative[j] += won / double(positive.size());
    }
  Components c{.area = sum / double(positive.size() * negative.size()), .variance = -1};
  if (positive.size() > 1 && negative.size() > 1)
    c.variance = varianceOf(ofPositive, c.area) / double(positive.size()) +
                 varianceOf(ofNegative, c.area) / double(negative.size());
  return c;
}

}  // namespace

RocArea rocArea(std::span<const double> positive, std::span<const double> negative) {
  const auto [area, variance] = componentsOf(positive, negative);
  if (variance < 0) return {area, 0, 1};
  if (variance < 1e-12) {
    // If all pairs agree: the exact bound (Clopper and Pearson) of a share that every value of the smaller group meets.
    const double bound = std::pow(0.025, 1 / double(std::min(positive.size(), negative.size())));
    return area > 0.5 ? RocArea{area, bound, 1} : area < 0.5 ? RocArea{area, 0, 1 - bound} : RocArea{area, 0, 1};
  }
  const double error = std::sqrt(variance), inside = area;
  const double logit = std::log(inside / (1 - inside)), reach = kNormal95 * error / (inside * (1 - inside));
  const auto back = [](double x) { return 1 / (1 + std::exp(-x)); };
  return {area, std::min(area, back(logit - reach)), std::max(area, back(logit + reach))};
}

double rocP(std::span<const double> positive, std::span<const double> negative) {
  const double m = double(positive.size()), n = double(negative.size());
  if (m < 2 || n < 2) return 1;
  // Variance of Mann and Whitney's statistic under the null hypothesis, without ties.
  const double error = std::sqrt((m + n + 1) / (12 * m * n));
  const double z = std::abs(componentsOf(positive, negative).area - 0.5) / error;
  return std::erfc(z / std::sqrt(2.0));
}

RocArea readersRocArea(std::span<const ReaderRatings> readers, unsigned seed) {
  constexpr int kDraws = 4000;
  if (readers.empty()) return {0.5, 0, 1};
  RocArea mean{0, 0, 0};
  for (const ReaderRatings& reader : readers)
    mean.area += componentsOf(reader.positive, reader.negative).area / double(readers.size());
  const std::size_t positives = readers.front().positive.size(), negatives = readers.front().negative.size();
  if (positives < 2 || negatives < 2) return {mean.area, 0, 1};
  std::mt19937 random(seed);
  const auto drawn = [&](std::size_t count) {
    std::vector<std::size_t> indices(count);
    for (auto& index : indices) index = std::uniform_int_distribution<std::size_t>(0, count - 1)(random);
    return indices;
  };
  std::vector<double> areas;
  areas.reserve(kDraws);
  for (int draw = 0; draw < kDraws; ++draw) {
    const auto who = drawn(readers.size()), real = drawn(negatives), made = drawn(positives);
    double area = 0;
    for (const std::size_t r : who) {
      double won = 0;
      for (const std::size_t i : made)
        for (const std::size_t j : real) won += beats(readers[r].positive[i], readers[r].negative[j]);
      area += won / double(positives * negatives * who.size());
    }
    areas.push_back(area);
  }
  std::ranges::sort(areas);
  mean.low = areas[kDraws / 40], mean.high = areas[kDraws - 1 - kDraws / 40];
  return mean;
}

}  // namespace insonate
