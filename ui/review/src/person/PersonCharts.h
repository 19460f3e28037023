#pragma once

#include "../class/MetricBook.h"
#include "PersonReading.h"

#include <insonate/ui/LearningChart.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace insonate::review {

/// A person's attempts at a level that count, in their order; "" for all levels.
std::vector<const AttemptFacts*> attemptsAt(const PersonFacts& facts, const std::string& level);

/// A metric over those attempts. Norms are those of the procedure, where they all had the same.
ui::ChartPicture learningOf(const PersonFacts& facts, const std::string& level, const MetricMeaning& meaning);
/// LC-CUSUM at a level whose rule asks for it, over the same attempts by the same numbers; else words.
ui::ChartPicture cusumOf(const PersonFacts& facts, const std::string& level);
/// The person's mean of the last kLastAttempts among those of the class; an empty `heat` is that of who does not see
/// the class.
ui::ChartPicture placeInClass(const PersonFacts& facts, const HeatMap& heat, const MetricMeaning& meaning);

}  // namespace insonate::review
