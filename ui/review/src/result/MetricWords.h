#pragma once

#include <insonate/procedure/AttemptScore.h>

#include <QString>

namespace insonate::review {

/// Formats a norm with as many digits as its study reports.
QString normOf(Metric metric, double value);
/// Explains, for a tooltip, what the metric counts, who measured novices and experts, and the evidence.
QString explanationOf(const MetricScore& score);

}  // namespace insonate::review
