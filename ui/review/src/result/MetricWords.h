#pragma once

#include <insonate/procedure/AttemptScore.h>

#include <QString>
#include <optional>

namespace insonate::review {

/// "needle path", of a metric's id.
QString titleOf(const MetricDefinition& metric);
/// "41.2 mm", "2", "n/a".
QString valueOf(const MetricDefinition& metric, const std::optional<double>& value);
/// Of people, with the digits that their study gives.
QString normOf(const MetricDefinition& metric, double value);
/// What is counted, who measured novices and experts, and the evidence; for a tooltip.
QString explanationOf(const MetricScore& score);

const MetricDefinition& definitionOf(Metric metric);

}  // namespace insonate::review
