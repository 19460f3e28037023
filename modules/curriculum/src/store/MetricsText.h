#pragma once

#include <insonate/curriculum/AttemptFacts.h>

#include <string>
#include <vector>

namespace insonate::store {

/// Writes metrics as JSON: [[id, version, value or null], ...].
std::string metricsText(const std::vector<MetricFact>& metrics);
/// Reads metrics from the JSON that metricsText() writes; empty for any other text.
std::vector<MetricFact> metricsOf(const std::string& text);

}  // namespace insonate::store
