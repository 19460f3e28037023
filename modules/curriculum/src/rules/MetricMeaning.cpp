#include <insonate/curriculum/MetricMeaning.h>

#include <algorithm>
#include <cmath>

namespace insonate {

std::optional<double> MetricMeaning::positionBetweenNorms(double value) const {
  const auto position = unclampedPosition(value);
  return position ? std::optional(std::clamp(*position, 0.0, 100.0)) : std::nullopt;
}

std::optional<double> MetricMeaning::unclampedPosition(double value) const {
  if (!novice || !expert || *novice == *expert || !std::isfinite(value)) return std::nullopt;
  return 100 * (value - *novice) / (*expert - *novice);
}

bool MetricMeaning::inExpertBand(double value) const {
  if (!expert) return false;
  if (better == Better::Lower) return value <= *expert;
  return better == Better::Higher && value >= *expert;
}

}  // namespace insonate
