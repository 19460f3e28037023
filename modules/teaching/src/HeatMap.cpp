#include <insonate/curriculum/Judgement.h>
#include <insonate/curriculum/Statistics.h>
#include <insonate/teaching/HeatMap.h>
#include <insonate/teaching/MetricCatalog.h>

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

/// Cividis at 0, 25, 50, 75 and 100 %.
constexpr std::array<HeatColor, 5> kCividis{
    {{0, 34, 78}, {63, 77, 107}, {124, 123, 120}, {188, 175, 111}, {254, 232, 56}}};

/// The attempt's position on the scale of its procedure, which may lie beyond the norms; for points, the points.
std::optional<double> positionIn(const AttemptFacts& attempt, const MetricMeaning& meaning) {
  const MetricMeaning& normed = MetricCatalog::instance().withNormsOf(attempt.procedure, meaning);
  if (!normed.expert) return shareIn(attempt, meaning);
  const auto value = valueIn(attempt, meaning);
  return value ? normed.unclampedPosition(*value) : std::nullopt;
}

/// The share on the scale of the result page: the mean is clamped, and not each attempt. A single attempt has a count
/// of 0 or 1, which lies beyond both norms; the mean of clamped shares would show the rate of punctures, not its
/// position between the rates of novices and experts.
std::optional<double> shareOfMean(const std::vector<double>& positions) {
  const auto mean = meanValue(positions);
  return mean ? std::optional(std::clamp(*mean, 0.0, 100.0)) : std::nullopt;
}

}  // namespace

HeatMap heatMapOf(std::span<const AttemptFacts> attempts) {
  const MetricCatalog& book = MetricCatalog::instance();
  std::map<std::string, std::vector<const AttemptFacts*>> byPerson;
  for (const AttemptFacts& attempt : attempts)
    if (isInFigures(attempt)) byPerson[attempt.person].push_back(&attempt);
  HeatMap map;
  for (const auto& [person, theirs] : byPerson) {
    auto& row = map[person];
    for (const MetricMeaning& meaning : book.all()) {
      std::vector<double> values, positions;
      for (const AttemptFacts* attempt : theirs) {
        if (const auto value = valueIn(*attempt, meaning)) values.push_back(*value);
        if (const auto position = positionIn(*attempt, meaning)) positions.push_back(*position);
      }
      row.push_back({meanValue(values), shareOfMean(positions), static_cast<int>(values.size())});
    }
  }
  return map;
}

HeatColor heatColorOf(double share) {
  const double at = std::clamp(share, 0.0, 100.0) / 100 * (kCividis.size() - 1);
  const auto low = std::min(static_cast<std::size_t>(at), kCividis.size() - 2);
  const double part = at - static_cast<double>(low);
  HeatColor color{};
  for (std::size_t i = 0; i < color.size(); ++i)
    color[i] = static_cast<int>(std::lround(kCividis[low][i] * (1 - part) + kCividis[low + 1][i] * part));
  return color;
}

bool needsBlackText(const HeatColor& background) {
  // Relative luminance of WCAG 2; black and white have equal contrast at 0.18.
  const auto linear = [](int channel) {
    const double c = channel / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(background[0]) + 0.7152 * linear(background[1]) + 0.0722 * linear(background[2]) > 0.18;
}

std::string heatWords(const std::optional<double>& share) {
  if (!share) return "no published values";
  return *share >= 99   ? "as an expert"
         : *share >= 67 ? "near expert"
         : *share >= 34 ? "midway"
         : *share > 1   ? "far from expert"
                        : "as a novice";
}

}  // namespace insonate
