#pragma once

#include <insonate/curriculum/AttemptFacts.h>

#include <array>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace insonate {

/// Summary of a person's last attempts in one metric.
struct HeatCell {
  std::optional<double> value{};  ///< mean in the metric's unit; empty if no attempt has a value
  /// position of the mean on the scale from the published novice value (0) to the expert value (100) of the attempts'
  /// procedures, clamped; empty without norms
  std::optional<double> share{};
  int attempts = 0;  ///< number of attempts that have a value
};

/// Cells by Person::id; each person has one cell per metric of MetricCatalog::all(), in the same order.
using HeatMap = std::map<std::string, std::vector<HeatCell>>;

/// Computes the heat map of many people's attempts, without those that do not count (Judgement.h).
HeatMap heatMapOf(std::span<const AttemptFacts> attempts);

/// Red, green and blue, 0 to 255 (sRGB).
using HeatColor = std::array<int, 3>;
/// Returns the color of a share from dark blue (novice) over gray to yellow (expert), after cividis (Nunez, Anderton,
/// Renslow, PLoS ONE 2018, 13:e0199239). Lightness rises too, and people with any kind of color vision can distinguish
/// the colors.
HeatColor heatColorOf(double share);
/// Tells whether black text is more legible than white text on this background.
bool needsBlackText(const HeatColor& background);
/// Describes a share in words: "as a novice", "far from expert", "midway", "near expert", "as an expert".
std::string heatWords(const std::optional<double>& share);

}  // namespace insonate
