#include "MetricSeries.h"

#include <insonate/curriculum/Judgement.h>
#include <insonate/teaching/TeachingHere.h>

#include <nlohmann/json.hpp>

#include <algorithm>

namespace insonate::cli {

std::map<std::string, Attempts> figuresByProcedure(std::span<const AttemptFacts> attempts) {
  std::map<std::string, Attempts> sorted;
  for (const AttemptFacts& attempt : attempts)
    if (isInFigures(attempt)) sorted[attempt.procedure].push_back(&attempt);
  return sorted;
}

std::vector<MetricMeaning> meaningsFor(const std::string& procedure) {
  const auto known = builtInProcedure(procedure);
  return known ? metricMeanings(*known) : metricMeanings();
}

std::vector<std::optional<double>> seriesOf(const Attempts& attempts, const MetricMeaning& metric) {
  std::vector<std::optional<double>> series;
  for (const AttemptFacts* attempt : attempts) series.push_back(valueOf(*attempt, metric.id, metric.version));
  return series;
}

std::vector<double> valuesOf(const Attempts& attempts, const MetricMeaning& metric) {
  std::vector<double> values;
  for (const auto& value : seriesOf(attempts, metric))
    if (value) values.push_back(*value);
  return values;
}

std::optional<Estimate> successOf(const Attempts& attempts) {
  return proportion(
      static_cast<int>(std::ranges::count_if(attempts, [](const AttemptFacts* one) { return isSuccess(*one); })),
      static_cast<int>(attempts.size()));
}

nlohmann::json toJson(const std::optional<Estimate>& estimate) {
  if (!estimate) return nullptr;
  nlohmann::json object{{"value", estimate->value}, {"low", nullptr}, {"high", nullptr}, {"by", nullptr}};
  if (estimate->interval) object.update({{"low", estimate->interval->low}, {"high", estimate->interval->high}});
  if (!estimate->basis.empty()) object["by"] = estimate->basis;
  return object;
}

}  // namespace insonate::cli
