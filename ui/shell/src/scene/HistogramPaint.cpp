#include "HistogramPlot.h"

#include <insonate/ui/HistogramBars.h>
#include <insonate/ui/Theme.h>

#include <QLinearGradient>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace insonate::ui {
namespace {

namespace theme = views::theme;
constexpr double kNode_px = 5, kStrip_px = 6;

QColor faint(views::Color base, double share) {
  QColor result = toQColor(base);
  result.setAlphaF(share);
  return result;
}

/// Round numbers, four to eight of which fit.
double tickStep(double range) {
  for (const double step : {50.0, 100.0, 200.0, 250.0, 500.0, 1000.0})
    if (range / step <= 7) return step;
  return 1000;
}

}  // namespace

void paintBars(QPainter& painter, const views::HuHistogram& histogram, const QRectF& area,
               const std::function<double(double hu)>& placeOf) {
  if (histogram.counts.empty()) return;
  const auto most = double(*std::max_element(histogram.counts.begin(), histogram.counts.end()));
  const double full = std::log1p(std::max(1.0, most));
  painter.setPen(Qt::NoPen);
  painter.setBrush(toQColor(theme::kLine));
  const double bin_HU = histogram.binWidth_HU();
  for (std::size_t bin = 0; bin < histogram.counts.size(); ++bin) {
    const double left = placeOf(histogram.min_HU + double(bin) * bin_HU);
    const double right = placeOf(histogram.min_HU + double(bin + 1) * bin_HU);
    const double high = area.height() * std::log1p(double(histogram.counts[bin])) / full;
    painter.drawRect(QRectF(left, area.bottom() - high, std::max(0.75, right - left), high));
  }
}

void HistogramPlot::paintWindow(QPainter& painter, const QRectF& area) const {
  if (!window_) return;
  const double low = window_->level_HU - window_->window_HU / 2, high = window_->level_HU + window_->window_HU / 2;
  const double left = std::clamp(placeOf(low, 0).x(), area.left(), area.right());
  const double right = std::clamp(placeOf(high, 0).x(), area.left(), area.right());
  const QRectF band(left, area.top(), right - left, area.height());
  QLinearGradient grays(band.topLeft(), band.topRight());
  grays.setColorAt(0, QColor(0, 0, 0, 70));
  grays.setColorAt(1, QColor(255, 255, 255, 46));
  painter.fillRect(band, grays);
  painter.setPen(QPen(faint(theme::kText, 0.35), 1, Qt::DotLine));
  painter.drawLine(band.topLeft(), band.bottomLeft());
  painter.drawLine(band.topRight(), band.bottomRight());
}

void HistogramPlot::paintAxes(QPainter& painter, const QRectF& area) const {
  QFont small = font();
  small.setPointSizeF(font().pointSizeF() * 0.8);
  painter.setFont(small);
  const double step = tickStep(max_HU_ - min_HU_);
  for (double hu = std::ceil(min_HU_ / step) * step; hu <= max_HU_; hu += step) {
    const double x = placeOf(hu, 0).x();
    painter.setPen(faint(theme::kLine, 0.6));
    painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    const QString text = QString::number(hu, 'f', 0).replace(QLatin1Char('-'), QChar(0x2212));
    const double width = painter.fontMetrics().horizontalAdvance(text);
    const double left = std::clamp(x - width / 2, 0.0, this->width() - width);
    painter.setPen(toQColor(theme::kQuiet));
    painter.drawText(QPointF(left, height() - 4), text);
  }
  for (const double opacity : {0.1, 0.5, 1.0}) {
    const double y = placeOf(0, opacity).y();
    painter.setPen(QPen(faint(theme::kLine, 0.9), 1, Qt::DotLine));
    painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
    painter.setPen(toQColor(theme::kQuiet));
    const QString text = tr("%1 %").arg(opacity * 100, 0, 'f', 0);
    painter.drawText(
        QPointF(area.right() - painter.fontMetrics().horizontalAdvance(text) - 2, y + small.pointSizeF() + 3), text);
  }
}

void HistogramPlot::paintFunction(QPainter& painter, const QRectF& area) const {
  if (function_.nodes.empty()) return;
  // The scale is not linear, so that linear opacity is a curve here.
  QPainterPath curve;
  QLinearGradient colors(area.topLeft(), area.topRight());
  curve.moveTo(placeOf(min_HU_, function_.opacityAt(min_HU_)));
  for (double x = area.left(); x <= area.right(); x += 2) curve.lineTo(placeOf(huAt(x), function_.opacityAt(huAt(x))));
  for (const views::TransferNode& node : function_.nodes) {
    const double share = std::clamp((node.hu - min_HU_) / (max_HU_ - min_HU_), 0.0, 1.0);
    colors.setColorAt(share, toQColor(node.color));
  }
  painter.fillRect(QRectF(area.left(), area.bottom(), area.width(), kStrip_px), colors);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(toQColor(theme::kText), 1.5));
  painter.drawPath(curve);
  for (int node = 0; node < int(function_.nodes.size()); ++node) {
    const views::TransferNode& at = function_.nodes[std::size_t(node)];
    const bool chosen = node == selected_;
    painter.setBrush(toQColor(at.color));
    painter.setPen(QPen(toQColor(chosen ? theme::kAccent : theme::kText), chosen ? 2.5 : 1.5));
    const double radius = chosen ? kNode_px + 1.5 : kNode_px;
    painter.drawEllipse(placeOf(at.hu, at.opacity), radius, radius);
  }
}

void HistogramPlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const QRectF area = field();
  painter.fillRect(area, toQColor(theme::kGround));
  paintBars(painter, histogram_, area, [this](double hu) { return placeOf(hu, 0).x(); });
  paintWindow(painter, area);
  painter.setRenderHint(QPainter::Antialiasing);
  paintAxes(painter, area);
  paintFunction(painter, area);
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(toQColor(hasFocus() ? theme::kAccent : theme::kLine));
  painter.drawRect(QRectF(area.left(), area.top(), area.width() - 1, area.height() + kStrip_px - 1));
}

}  // namespace insonate::ui
