#pragma once

#include <insonate/procedure/AttemptMetrics.h>
#include <insonate/procedure/Procedure.h>

#include <QString>
#include <cstdint>
#include <optional>

namespace insonate::ui {

/// Symbol and words for the needle's place; StateColors.h has its color.
struct PlaceWords {
  QString sign, words;
};
/// Returns symbol and words for a place of the needle. `vessel`: name of the vessel in which the tip is; empty if the
/// tip is in no vessel or the name is unknown.
PlaceWords displayText(NeedlePlace place, const QString& vessel = {});

QString nameOf(Severity severity);

/// Returns a metric's title, for example "needle path".
QString titleOf(Metric metric);
/// Formats a metric's value: "41.2 mm", "34.6°", "2", "n/a".
QString valueOf(Metric metric, const std::optional<double>& value);

/// Formats AttemptFacts::begun_us in local time: "20 Nov 2026, 14:05".
QString dayAndTimeOf(std::int64_t time_us);

}  // namespace insonate::ui
