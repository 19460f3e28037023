#pragma once

#include "PersonReading.h"

#include <insonate/teaching/MetricBook.h>
#include <insonate/ui/LearningChart.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace insonate::review {

/// Returns the person's attempts at a level that count, in their order; "" for all levels.
std::vector<const AttemptFacts*> attemptsAt(const PersonFacts& facts, const std::string& level);

/// Chart of a metric over attemptsAt(). It shows the procedure's norms if all these attempts are of one procedure.
ui::ChartPicture learningOf(const PersonFacts& facts, const std::string& level, const MetricMeaning& meaning);
/// Chart of the LC-CUSUM score over attemptsAt(), if the level's rule uses it; else a chart with an explanation.
ui::ChartPicture cusumOf(const PersonFacts& facts, const std::string& level);
/// Chart of the person's mean over the last kLastAttempts among the means of the class. `heat` is empty for users who
/// may not see the class.
ui::ChartPicture placeInClass(const PersonFacts& facts, const HeatMap& heat, const MetricMeaning& meaning);

}  // namespace insonate::review
