#pragma once

#include <insonate/curriculum/Curriculum.h>
#include <insonate/ui/Chart.h>

#include <optional>
#include <span>
#include <vector>

namespace insonate::ui {

/// A metric over a person's attempts, in their order; a gap for an attempt without a value. With the fitted curve and
/// its 95 % interval if the values show one, else the mean of the last kLastAttempts; and the expert band, if known.
ChartPicture learningPicture(const MetricMeaning& meaning, std::span<const std::optional<double>> values);

/// The LC-CUSUM score after each attempt, from `passes`, and the limit that it has to reach, with the rule's rates.
ChartPicture cusumPicture(const std::vector<bool>& passes, const CusumRule& rule);

}  // namespace insonate::ui
