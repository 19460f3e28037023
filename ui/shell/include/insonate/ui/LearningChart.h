#pragma once

#include <insonate/curriculum/Curriculum.h>
#include <insonate/ui/Chart.h>

#include <optional>
#include <span>
#include <vector>

namespace insonate::ui {

/// Makes a chart of a metric over the attempts of a person, in their order, with a gap for an attempt without a value.
/// The chart also contains the fitted learning curve with its 95 % interval if fitLearningCurve() succeeds, else the
/// mean of the last kLastAttempts values; and the band of expert values, if known.
ChartContents learningChart(const MetricMeaning& meaning, std::span<const std::optional<double>> values);

/// Makes a chart of the LC-CUSUM score after each attempt, with the limit that the score has to reach and the failure
/// rates of the rule. `passes`: for each attempt, whether it was passed.
ChartContents cusumChart(const std::vector<bool>& passes, const CusumRule& rule);

}  // namespace insonate::ui
