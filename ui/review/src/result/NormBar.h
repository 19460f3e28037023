#pragma once

#include <insonate/procedure/AttemptScore.h>
#include <insonate/ui/Ink.h>

#include <QPainter>
#include <QRectF>

namespace insonate::review {

/// Paints a value between the values of novices (left) and experts (right), whichever of the two is the larger number:
/// a band from one to the other, and a mark at the value. If the value is beyond an end of the band, the mark is an
/// arrow. Paints nothing if one of the three values is missing.
void paintNormBar(QPainter& painter, const QRectF& place, const MetricScore& score, const ui::Ink& ink);

}  // namespace insonate::review
