#pragma once

#include <insonate/procedure/AttemptMetrics.h>

#include <string_view>

namespace insonate {

/// The metric's name wherever people read it: "posterior wall punctures". The unit stands beside the value. Defined in
/// the help's glossary.
std::string_view metricTitle(Metric metric);

}  // namespace insonate
