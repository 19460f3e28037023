#pragma once

#include <insonate/curriculum/Curriculum.h>
#include <insonate/ui/Chart.h>

#include <optional>
#include <span>
#include <vector>

namespace insonate::ui {

/// Chart of a metric over a person's attempts, in their order, with a gap for an attempt without a value. Shows the
/// fitted curve with its 95 % interval if the values support a fit, else the mean of the last kLastAttempts; and the
/// expert band, if known.
ChartPicture learningPicture(const MetricMeaning& meaning, std::span<const std::optional<double>> values);

/// Chart of the LC-CUSUM score after each attempt, computed from `passes`, with the limit that the score has to reach
/// and the rule's rates.
ChartPicture cusumPicture(const std::vector<bool>& passes, const CusumRule& rule);

}  // namespace insonate::ui
