#pragma once

#include <insonate/procedure/AttemptScore.h>
#include <insonate/views/Theme.h>

#include <QString>

namespace insonate::train {

/// How the needle's place is told: by a sign and words as well as by the thesis's colour.
struct PlaceWords {
  QString sign, words;
  views::Colour colour;
};
PlaceWords wordsOf(NeedlePlace place);

/// What can be seen without a teacher: whether the needle is in the skin, and whether it was.
NeedlePlace plainly(NeedlePlace place);

/// A metric's name, short enough for a column, and its value with unit; a dash where it is missing.
QString nameOf(Metric metric);
QString valueOf(Metric metric, const MetricValues& values);

views::Colour colourOf(Severity severity);
QString wordOf(Severity severity);

/// "2:07".
QString clockOf(double time_s);

/// The line over a result: "71 of 100: the vein was reached", "Abandoned".
QString headlineOf(const AttemptScore& score, AttemptStatus status);

}  // namespace insonate::train
