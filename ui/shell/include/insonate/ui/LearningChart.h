#pragma once

#include <insonate/curriculum/MetricMeaning.h>
#include <insonate/ui/Chart.h>

#include <optional>
#include <span>

namespace insonate::ui {

/// A metric over a person's attempts, in their order; none where an attempt does not tell. With the fitted curve and
/// its 95 % interval where the values show one, else the mean of the last five; and the expert band, where it is known.
ChartPicture learningPicture(const MetricMeaning& meaning, std::span<const std::optional<double>> values);

/// The LC-CUSUM score after each attempt, and the limit that it has to reach.
ChartPicture cusumPicture(std::span<const double> scores, double limit);

}  // namespace insonate::ui
