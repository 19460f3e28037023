#pragma once

#include <insonate/procedure/AttemptScore.h>
#include <insonate/ui/Ink.h>

#include <QPainter>
#include <QRectF>

namespace insonate::review {

/// Paints a value between the values of novices (left) and experts (right), whichever is the larger number: a band
/// between the two, and a mark for the value, which is an arrow if the value is beyond an end. Paints nothing if one of
/// the three is missing.
void paintNormBar(QPainter& painter, const QRectF& place, const MetricScore& score, const ui::Ink& ink);

}  // namespace insonate::review
