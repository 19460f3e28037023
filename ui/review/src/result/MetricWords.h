#pragma once

#include <insonate/procedure/AttemptScore.h>

#include <QString>

namespace insonate::review {

/// Of people, with the digits that their study gives.
QString normOf(Metric metric, double value);
/// What is counted, who measured novices and experts, and the evidence; for a tooltip.
QString explanationOf(const MetricScore& score);

}  // namespace insonate::review
