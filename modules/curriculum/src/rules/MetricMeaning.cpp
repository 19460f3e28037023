#include <insonate/curriculum/MetricMeaning.h>

#include <algorithm>
#include <cmath>

namespace insonate {

std::optional<double> MetricMeaning::positionBetweenNorms(double value) const {
  if (!novice || !expert || *novice == *expert || !std::isfinite(value)) return std::nullopt;
  return 100 * std::clamp((value - *novice) / (*expert - *novice), 0.0, 1.0);
}

bool MetricMeaning::inExpertBand(double value) const {
  if (!expert) return false;
  if (better == Better::Lower) return value <= *expert;
  return better == Better::Higher && value >= *expert;
}

}  // namespace insonate
