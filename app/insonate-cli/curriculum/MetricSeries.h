#pragma once

#include <insonate/curriculum/AttemptFacts.h>
#include <insonate/curriculum/MetricMeaning.h>
#include <insonate/curriculum/Statistics.h>

#include <nlohmann/json_fwd.hpp>

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace insonate::cli {

using Attempts = std::vector<const AttemptFacts*>;

/// Groups the attempts whose values enter means and curves (isInFigures()) by their procedure, since values of
/// different procedures are not comparable; the order within a procedure stays.
std::map<std::string, Attempts> figuresByProcedure(std::span<const AttemptFacts> attempts);
/// Returns the properties of all metrics, with published values of novices and experts if the procedure is built in.
std::vector<MetricMeaning> meaningsFor(const std::string& procedure);
/// Returns the values of a metric in these attempts, without missing values.
std::vector<double> valuesOf(const Attempts& attempts, const MetricMeaning& metric);
/// Returns the value of a metric in each attempt, in the order of attempts; empty if missing.
std::vector<std::optional<double>> seriesOf(const Attempts& attempts, const MetricMeaning& metric);
std::optional<Estimate> successOf(const Attempts& attempts);

/// Returns an estimate as JSON {"value", "low", "high", "by"}; null without an estimate. low and high are null without
/// an interval; "by" is Estimate::basis.
nlohmann::json toJson(const std::optional<Estimate>& estimate);

}  // namespace insonate::cli
