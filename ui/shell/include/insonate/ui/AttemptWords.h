#pragma once

#include <insonate/procedure/AttemptMetrics.h>
#include <insonate/procedure/Procedure.h>
#include <insonate/views/Theme.h>

#include <QString>
#include <cstdint>
#include <optional>

namespace insonate::ui {

/// Presentation of the needle's place: a sign and words as well as the thesis's color.
struct PlaceWords {
  QString sign, words;
  views::Colour colour;
};
/// `vessel`: the name of the vessel that the tip is in; empty if it is in none or the name is unknown.
PlaceWords wordsOf(NeedlePlace place, const QString& vessel = {});

/// Color of a finding; quiet if there is none.
views::Colour colourOf(const std::optional<Severity>& severity);
QString wordOf(Severity severity);

/// "needle path", of a metric's id.
QString titleOf(Metric metric);
/// "41.2 mm", "34.6°", "2", "n/a".
QString valueOf(Metric metric, const std::optional<double>& value);

/// "20 Nov 2026, 14:05", here, of AttemptFacts::begun_us.
QString dayAndTimeOf(std::int64_t time_us);

}  // namespace insonate::ui
