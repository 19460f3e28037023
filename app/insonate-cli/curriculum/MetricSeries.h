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

/// Attempts that count, in their order, by procedure: what two procedures measure is not alike.
std::map<std::string, Attempts> countedByProcedure(std::span<const AttemptFacts> attempts);
/// With the procedure's norms, where it is one of ours.
std::vector<MetricMeaning> meaningsFor(const std::string& procedure);
/// The values that are not missing.
std::vector<double> valuesOf(const Attempts& attempts, const MetricMeaning& metric);
/// One for each attempt, so that attempts keep their numbers.
std::vector<std::optional<double>> seriesOf(const Attempts& attempts, const MetricMeaning& metric);
std::optional<Estimate> successOf(const Attempts& attempts);

/// {"value", "low", "high", "by"}, null where there is none; "by" is Estimate::basis.
nlohmann::json toJson(const std::optional<Estimate>& estimate);

}  // namespace insonate::cli
