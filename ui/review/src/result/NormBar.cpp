#include "NormBar.h"

#include <insonate/ui/Theme.h>

#include <QPolygonF>
#include <algorithm>

namespace insonate::review {
namespace {

namespace theme = views::theme;

/// Share of the band's length that extends on either side of it.
constexpr double kBeyond = 0.35;

}  // namespace

ResultInk screenInk() {
  using ui::colour;
  return {colour(theme::kText), colour(theme::kQuiet),  colour(theme::kLine),    colour(theme::kRaised),
          colour(theme::kGood), colour(theme::kAccent), colour(theme::kCaution), colour(theme::kDanger)};
}

ResultInk paperInk() {
  return {QColor(0x1a, 0x1e, 0x23), QColor(0x55, 0x5f, 0x68), QColor(0xb4, 0xbc, 0xc4), QColor(0xe6, 0xea, 0xee),
          QColor(0x1f, 0x7a, 0x4b), QColor(0x1b, 0x6a, 0xa5), QColor(0xa8, 0x6c, 0x00), QColor(0xb3, 0x26, 0x1e)};
}

void paintNormBar(QPainter& painter, const QRectF& place, const MetricScore& score, const ResultInk& ink) {
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
    painter.setBrush(way >= 1 ? ink.good : way <= 0 ? ink.caution : ink.accent);
    const double side = way > 1 + kBeyond ? 1 : way < -kBeyond ? -1 : 0;
    if (side == 0)
      painter.drawEllipse(QPointF(x, y), 5, 5);
    else
      painter.drawPolygon(QPolygonF({{x, y}, {x - side * 9, y - 6}, {x - side * 9, y + 6}}));
  }
  painter.restore();
}

}  // namespace insonate::review
