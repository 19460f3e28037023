#pragma once

#include "PersonReading.h"

#include <insonate/teaching/MetricCatalog.h>
#include <insonate/ui/LearningChart.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace insonate::review {

/// Returns those of the person's attempts at a level that count, in their order. `level` "": attempts at all levels.
std::vector<const AttemptFacts*> attemptsAt(const PersonFacts& facts, const std::string& level);

/// Returns a chart of a metric over attemptsAt(). The chart shows the procedure's norms if all these attempts have the
/// same procedure.
ui::ChartContents learningOf(const PersonFacts& facts, const std::string& level, const MetricMeaning& meaning);
/// Returns a chart of the LC-CUSUM score over attemptsAt(), if the level's rule uses LC-CUSUM; else a chart with an
/// explanation.
ui::ChartContents cusumOf(const PersonFacts& facts, const std::string& level);
/// Returns a chart that compares the person's mean over the last kLastAttempts with the means of the other people in
/// the class. `heat` is empty for users who may not see the class.
ui::ChartContents placeInClass(const PersonFacts& facts, const HeatMap& heat, const MetricMeaning& meaning);

}  // namespace insonate::review
