#pragma once

#include "MetricBook.h"

#include <insonate/curriculum/AttemptFacts.h>

#include <QColor>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace insonate::review {

/// A person's last attempts in one metric.
struct HeatCell {
  std::optional<double> value;  ///< mean, in the metric's unit; none: no attempt tells it
  std::optional<double> share;  ///< mean of 0 (as a novice) to 100 (as an expert); none: nothing to compare with
  int attempts = 0;             ///< that tell it
};

/// Cells by Person::id, one for each of MetricBook::all().
using HeatMap = std::map<std::string, std::vector<HeatCell>>;

/// Heat map of many people's attempts. Those that do not count (Judgement.h) are left out.
HeatMap heatMapOf(std::span<const AttemptFacts> attempts);

/// Maps dark blue (novice) over gray to yellow (expert), the colors of cividis (Nunez, Anderton, Renslow, PLoS ONE
/// 2018, 13:e0199239): they rise in lightness too, and people with any kind of color vision can distinguish them.
QColor heatColour(double share);
/// Black or white, whichever is read better on it.
QColor inkOn(const QColor& ground);
/// "as a novice", "far from expert", "midway", "near expert", "as an expert"; the same thing in words.
QString heatWords(const std::optional<double>& share);

}  // namespace insonate::review
