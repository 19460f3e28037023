#pragma once

#include <insonate/procedure/AttemptScore.h>

#include <QString>

namespace insonate::review {

/// Formats a norm with the digits that its study gives.
QString normOf(Metric metric, double value);
/// Explains what is counted, who measured novices and experts, and the evidence; for a tooltip.
QString explanationOf(const MetricScore& score);

}  // namespace insonate::review
