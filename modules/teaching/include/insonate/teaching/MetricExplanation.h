#pragma once

#include <insonate/procedure/AttemptMetrics.h>

#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// Part of the explanation of a metric: "Definition", and the definition.
struct MetricExplanation {
  std::string heading{}, text{};

  bool operator==(const MetricExplanation&) const = default;
};

/// Returns definition, source of the published values, and evidence of a metric. `source`: study in which the values of
/// novices and experts were measured; "": there are no such values.
std::vector<MetricExplanation> explanationOf(const MetricDefinition& metric, const std::string& source);

/// Formats a published value with four digits at most and its unit: "41.2 mm", "30°".
std::string publishedValue(double value, std::string_view unit);

}  // namespace insonate
