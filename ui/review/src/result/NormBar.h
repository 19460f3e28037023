#pragma once

#include <insonate/procedure/AttemptScore.h>

#include <QColor>
#include <QPainter>
#include <QRectF>

namespace insonate::review {

/// Colors of a painted result, for the screen or for paper.
struct ResultInk {
  QColor text, quiet, line, band, good, accent, caution, danger;
};
ResultInk screenInk();
ResultInk paperInk();

/// A value between what novices (left) and experts (right) reach, whichever is the larger number: a band from one to
/// the other, and the value's sign on it; beyond the ends an arrow. Nothing where one of the three is missing.
void paintNormBar(QPainter& painter, const QRectF& place, const MetricScore& score, const ResultInk& ink);

}  // namespace insonate::review
