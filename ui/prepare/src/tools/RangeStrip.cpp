#include "RangeStrip.h"

#include <insonate/ui/HistogramBars.h>
#include <insonate/ui/Theme.h>

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace insonate::prepare {
namespace {

constexpr double kReach_px = 8, kMargin_px = 6, kKnob_px = 8;

}  // namespace

RangeStrip::RangeStrip(QWidget* parent) : QWidget(parent) {
  setMouseTracking(true);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("Range of Hounsfield units on the histogram"));
  setToolTip(tr("Histogram of the CT values; drag a limit of the range, or the band between the limits"));
}

QRectF RangeStrip::field() const {
  return {kMargin_px, 2, width() - 2 * kMargin_px, height() - 4.0};
}

double RangeStrip::placeOf(double hu) const {
  const QRectF area = field();
  const double share = (hu - histogram_.min_HU) / (histogram_.max_HU - histogram_.min_HU);
  return area.left() + area.width() * std::clamp(share, 0.0, 1.0);
}

double RangeStrip::huAt(double x) const {
  const QRectF area = field();
  return histogram_.min_HU + (histogram_.max_HU - histogram_.min_HU) * (x - area.left()) / area.width();
}

void RangeStrip::setHistogram(const views::HuHistogram& histogram) {
  histogram_ = histogram;
  update();
}

void RangeStrip::setRange(HuRange range) {
  range_ = range;
  update();
}

void RangeStrip::setColor(views::Color color) {
  color_ = color;
  update();
}

RangeStrip::Part RangeStrip::partAt(double x) const {
  const double low = placeOf(range_.low), high = placeOf(range_.high);
  const double toLow = std::abs(x - low), toHigh = std::abs(x - high);
  if (std::min(toLow, toHigh) > kReach_px) return x > low && x < high ? Part::Both : Part::None;
  // If both handles are at one place, selects the one that can move there.
  if (toLow == toHigh) return x < low ? Part::Low : Part::High;
  return toLow < toHigh ? Part::Low : Part::High;
}

void RangeStrip::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  held_ = partAt(event->localPos().x());
  from_HU_ = huAt(event->localPos().x());
  before_ = range_;
}

void RangeStrip::mouseMoveEvent(QMouseEvent* event) {
  const double x = event->localPos().x();
  if (held_ == Part::None) {
    const Part under = partAt(x);
    setCursor(under == Part::None ? Qt::ArrowCursor : under == Part::Both ? Qt::OpenHandCursor : Qt::SizeHorCursor);
    return;
  }
  const int least = int(histogram_.min_HU), most = int(histogram_.max_HU);
  int by = int(std::lround(huAt(x) - from_HU_));
  HuRange wanted = before_;
  if (held_ == Part::Both) by = std::clamp(by, std::min(0, least - before_.low), std::max(0, most - before_.high));
  if (held_ != Part::High) wanted.low = std::clamp(before_.low + by, least, most);
  if (held_ != Part::Low) wanted.high = std::clamp(before_.high + by, least, most);
  // The ends do not pass each other.
  if (held_ == Part::Low) wanted.low = std::min(wanted.low, wanted.high);
  if (held_ == Part::High) wanted.high = std::max(wanted.low, wanted.high);
  if (wanted == range_) return;
  setRange(wanted);
  Q_EMIT dragged(wanted);
}

void RangeStrip::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) held_ = Part::None;
}

void RangeStrip::paintEvent(QPaintEvent*) {
  namespace theme = views::theme;
  QPainter painter(this);
  const QRectF area = field();
  painter.fillRect(area, ui::toQColor(theme::kGround));
  ui::paintBars(painter, histogram_, area, [this](double hu) { return placeOf(hu); });
  const double low = placeOf(range_.low), high = placeOf(range_.high);
  QColor band = ui::toQColor(color_);
  band.setAlphaF(0.35);
  painter.fillRect(QRectF(low, area.top(), std::max(1.0, high - low), area.height()), band);
  painter.setRenderHint(QPainter::Antialiasing);
  for (const double x : {low, high}) {
    painter.setPen(QPen(ui::toQColor(theme::kText), 1.5));
    painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    painter.setPen(Qt::NoPen);
    painter.setBrush(ui::toQColor(theme::kText));
    painter.drawEllipse(QPointF(x, area.center().y()), kKnob_px / 2, kKnob_px / 2);
  }
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(ui::toQColor(theme::kLine));
  painter.drawRect(area.adjusted(0, 0, -1, -1));
}

}  // namespace insonate::prepare
