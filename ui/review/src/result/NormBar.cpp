#include "NormBar.h"

#include <QPolygonF>
#include <algorithm>

namespace insonate::review {
namespace {

/// Share of the band's length that extends on either side of it.
constexpr double kBeyond = 0.35;

}  // namespace

void paintNormBar(QPainter& painter, const QRectF& place, const MetricScore& score, const ui::Ink& ink) {
  if (!score.norm) return;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  const double y = place.center().y(), unit = place.width() / (1 + 2 * kBeyond);
  const double novice = place.left() + unit * kBeyond, expert = novice + unit;
  painter.setPen(QPen(ink.line, 1));
  painter.drawLine(QPointF(place.left(), y), QPointF(place.right(), y));
  painter.setPen(Qt::NoPen);
  painter.setBrush(ink.line);
  painter.drawRect(QRectF(novice, y - 2, unit, 4));
  painter.setPen(QPen(ink.quiet, 1.4));
  for (const double end : {novice, expert}) painter.drawLine(QPointF(end, y - 6), QPointF(end, y + 6));
  if (score.value) {
    const double way = (*score.value - score.norm->novice) / (score.norm->expert - score.norm->novice);
    const double x = novice + unit * std::clamp(way, -kBeyond, 1 + kBeyond);
    painter.setPen(Qt::NoPen);
    const bool isPuncture = score.metric == Metric::ArteryPunctures || score.metric == Metric::LungPunctures;
    painter.setBrush(isPuncture && *score.value > 0 ? ink.danger
                     : way >= 1                     ? ink.good
                     : way <= 0                     ? ink.caution
                                                    : ink.accent);
    const double side = way > 1 + kBeyond ? 1 : way < -kBeyond ? -1 : 0;
    if (side == 0)
      painter.drawEllipse(QPointF(x, y), 5, 5);
    else
      painter.drawPolygon(QPolygonF({{x, y}, {x - side * 9, y - 6}, {x - side * 9, y + 6}}));
  }
  painter.restore();
}

}  // namespace insonate::review
