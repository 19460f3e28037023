#pragma once

#include <insonate/procedure/AttemptMetrics.h>

#include <optional>
#include <string>
#include <string_view>

namespace insonate {

/// Returns the name of a metric in the user interface, without its unit, e.g. "posterior wall punctures". The glossary
/// in resources/help defines these names.
std::string_view metricTitle(Metric metric);
/// Formats a metric's value: "41.2 mm", "34.6°", "2", "n/a".
std::string metricText(Metric metric, const std::optional<double>& value);

}  // namespace insonate
