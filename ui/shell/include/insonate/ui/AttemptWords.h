#pragma once

#include <insonate/procedure/AttemptMetrics.h>
#include <insonate/procedure/Procedure.h>

#include <QString>
#include <cstdint>
#include <optional>

namespace insonate::ui {

/// Sign and words of the needle's place; StateColors.h has its color.
struct PlaceWords {
  QString sign, words;
};
/// `vessel`: the name of the vessel that the tip is in; empty if it is in none or the name is unknown.
PlaceWords wordsOf(NeedlePlace place, const QString& vessel = {});

QString wordOf(Severity severity);

/// "needle path", of a metric's id.
QString titleOf(Metric metric);
/// "41.2 mm", "34.6°", "2", "n/a".
QString valueOf(Metric metric, const std::optional<double>& value);

/// "20 Nov 2026, 14:05", here, of AttemptFacts::begun_us.
QString dayAndTimeOf(std::int64_t time_us);

}  // namespace insonate::ui
