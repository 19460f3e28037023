#pragma once

#include <insonate/procedure/AttemptMetrics.h>

#include <string_view>

namespace insonate {

/// Name of a metric in the user interface: "posterior wall punctures". The unit is shown beside the value. The help's
/// glossary defines the name.
std::string_view metricTitle(Metric metric);

}  // namespace insonate
