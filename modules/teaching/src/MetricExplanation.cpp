#include <insonate/teaching/MetricExplanation.h>

#include <cstdio>

namespace insonate {

std::vector<MetricExplanation> explanationOf(const MetricDefinition& metric, const std::string& source) {
  std::vector<MetricExplanation> parts{{"Definition", std::string(metric.definition)}};
  if (source.empty())
    parts.push_back({"Novice and expert values", "none are known"});
  else
    parts.push_back({"Source of the novice and expert values", source});
  if (!metric.evidence.empty()) parts.push_back({"Evidence", std::string(metric.evidence)});
  return parts;
}

std::string publishedValue(double value, std::string_view unit) {
  char number[32];
  std::snprintf(number, sizeof number, "%.4g", value);
  if (unit.empty()) return number;
  return unit == "deg" ? std::string(number) + "\u00b0" : std::string(number) + " " + std::string(unit);
}

}  // namespace insonate
