#pragma once

#include <insonate/procedure/AttemptMetrics.h>

#include <string_view>

namespace insonate {

/// Returns the name of a metric in the user interface, without its unit, e.g. "posterior wall punctures". The glossary
/// in resources/help defines these names.
std::string_view metricTitle(Metric metric);

}  // namespace insonate
