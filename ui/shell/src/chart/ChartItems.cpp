#include "ChartItems.h"

#include <insonate/ui/Theme.h>

#include <qwt_legend.h>
#include <qwt_plot.h>
#include <qwt_plot_grid.h>
#include <qwt_plot_item.h>
#include <qwt_scale_draw.h>
#include <qwt_scale_map.h>
#include <qwt_scale_widget.h>

#include <QPainter>
#include <QPen>
#include <QPolygonF>
#include <algorithm>
#include <cmath>

namespace insonate::ui {
namespace {

constexpr double kDot_px = 3, kBandOpacity = 0.22;
/// Width of a box: half of its share of the axis, between these limits.
constexpr double kHalfBox = 0.08, kMinHalf_px = 17, kMaxHalf_px = 48;

QPolygonF onCanvas(const std::vector<QPointF>& points, const QwtScaleMap& x, const QwtScaleMap& y) {
  QPolygonF polygon;
  for (const QPointF& p : points) polygon << QPointF(x.transform(p.x()), y.transform(p.y()));
  return polygon;
}

/// Headers of Qwt's own curves and intervals are not valid C++20 (Qwt 6.1).
class Item : public QwtPlotItem {
 public:
  explicit Item(const QString& name) : QwtPlotItem(QwtText(name, QwtText::PlainText)) {
    setItemAttribute(QwtPlotItem::Legend, !name.isEmpty());
    setItemAttribute(QwtPlotItem::AutoScale);
    setRenderHint(QwtPlotItem::RenderAntialiased);
  }
  QwtGraphic legendIcon(int, const QSizeF&) const override {
    QwtGraphic icon;
    icon.setDefaultSize({24, 10});
    QPainter painter(&icon);
    painter.setRenderHint(QPainter::Antialiasing);
    paintSign(painter);
    return icon;
  }

 private:
  virtual void paintSign(QPainter& painter) const = 0;
};

QRectF around(const std::vector<QPointF>& points) {
  if (points.empty()) return {1, 1, -2, -2};  // Qwt's empty rectangle
  const auto [left, right] = std::ranges::minmax_element(points, {}, &QPointF::x);
  const auto [low, high] = std::ranges::minmax_element(points, {}, &QPointF::y);
  return {left->x(), low->y(), right->x() - left->x(), high->y() - low->y()};
}

class LineItem final : public Item {
 public:
  LineItem(const ChartContents::Line& line, const QColor& color)
      : Item(line.name), line_(line), pen_(color, 1.8, line.pen) {}
  QRectF boundingRect() const override { return around(line_.points); }
  void draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y, const QRectF&) const override {
    const QPolygonF points = onCanvas(line_.points, x, y);
    painter->setPen(pen_);
    if (line_.pen != Qt::NoPen) painter->drawPolyline(points);
    if (!line_.dots) return;
    dot(*painter);
    for (const QPointF& point : points) painter->drawEllipse(point, kDot_px, kDot_px);
  }

 private:
  void dot(QPainter& painter) const {
    painter.setPen(Qt::NoPen);
    painter.setBrush(pen_.color());
  }
  void paintSign(QPainter& painter) const override {
    painter.setPen(pen_);
    if (line_.pen != Qt::NoPen) painter.drawLine(0, 5, 24, 5);
    if (!line_.dots) return;
    dot(painter);
    painter.drawEllipse(QPointF(12, 5), kDot_px, kDot_px);
  }

  ChartContents::Line line_;
  QPen pen_;
};

class BandItem final : public Item {
 public:
  BandItem(const ChartContents::Band& band, QColor color) : Item(band.name), outline_(band.low), brush_(color) {
    outline_.insert(outline_.end(), band.high.rbegin(), band.high.rend());
    brush_.setAlphaF(kBandOpacity);
  }
  QRectF boundingRect() const override { return around(outline_); }
  void draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y, const QRectF&) const override {
    painter->setPen(Qt::NoPen);
    painter->setBrush(brush_);
    painter->drawPolygon(onCanvas(outline_, x, y));
  }

 private:
  void paintSign(QPainter& painter) const override { painter.fillRect(QRectF(0, 0, 24, 10), brush_); }

  std::vector<QPointF> outline_;
  QColor brush_;
};

class BoxItem final : public Item {
 public:
  BoxItem(const ChartContents::Box& box, const QColor& color) : Item({}), box_(box), color_(color) {}
  QRectF boundingRect() const override {
    const BoxPlot& n = box_.numbers;
    double low = n.lowerWhisker, high = n.upperWhisker;
    if (!n.outliers.empty()) low = std::min(low, n.outliers.front()), high = std::max(high, n.outliers.back());
    return {box_.x - 0.5, low, 1, high - low};
  }
  void draw(QPainter* painter, const QwtScaleMap& xMap, const QwtScaleMap& y, const QRectF&) const override {
    const BoxPlot& n = box_.numbers;
    const double x = xMap.transform(box_.x);
    const double half = std::clamp(xMap.transform(box_.x + kHalfBox) - x, kMinHalf_px, kMaxHalf_px);
    const auto across = [&](double value, double width) {
      painter->drawLine(QPointF(x - width, y.transform(value)), QPointF(x + width, y.transform(value)));
    };
    QColor inside = color_;
    inside.setAlphaF(kBandOpacity);
    painter->setPen(QPen(color_, 1.4));
    painter->drawLine(QPointF(x, y.transform(n.lowerWhisker)), QPointF(x, y.transform(n.lowerQuartile)));
    painter->drawLine(QPointF(x, y.transform(n.upperQuartile)), QPointF(x, y.transform(n.upperWhisker)));
    across(n.lowerWhisker, half / 2), across(n.upperWhisker, half / 2);
    painter->setBrush(inside);
    painter->drawRect(
        QRectF(QPointF(x - half, y.transform(n.upperQuartile)), QPointF(x + half, y.transform(n.lowerQuartile))));
    painter->setBrush(Qt::NoBrush);
    for (const double outlier : n.outliers) painter->drawEllipse(QPointF(x, y.transform(outlier)), kDot_px, kDot_px);
    painter->setPen(QPen(color_, 3));
    across(n.median, half);
  }

 private:
  void paintSign(QPainter&) const override {}

  ChartContents::Box box_;
  QColor color_;
};

/// Labels below a count axis: whole numbers, or a name for each.
class CountDraw final : public QwtScaleDraw {
 public:
  explicit CountDraw(QStringList names) : names_(std::move(names)) {}
  /// Qwt's own scale has no room below the labels.
  double extent(const QFont& font) const override { return QwtScaleDraw::extent(font) + QFontMetricsF(font).descent(); }
  QwtText label(double value) const override {
    const int at = int(std::lround(value));
    if (at != value) return {};
    if (names_.isEmpty()) return QString::number(at);
    return at >= 0 && at < names_.size() ? QwtText(names_[at], QwtText::PlainText) : QwtText();
  }

 private:
  QStringList names_;
};

QwtText small(const QString& words, const QColor& color, bool bold = false) {
  QwtText text(words, QwtText::PlainText);
  QFont font;
  font.setPointSizeF(bold ? font.pointSizeF() : font.pointSizeF() * 0.9);
  font.setBold(bold);
  text.setFont(font);
  text.setColor(color);
  return text;
}

void setAxes(QwtPlot& plot, const ChartContents& picture, const Ink& ink) {
  plot.setTitle(picture.title.isEmpty() ? QwtText() : small(picture.title, ink.text, true));
  plot.setAxisTitle(QwtPlot::xBottom, small(picture.xTitle, ink.quiet));
  plot.setAxisTitle(QwtPlot::yLeft, small(picture.yTitle, ink.quiet));
  plot.setAxisMaxMinor(QwtPlot::xBottom, 0);
  plot.setAxisMaxMinor(QwtPlot::yLeft, 0);
  plot.setAxisMaxMajor(QwtPlot::yLeft, 5);
  for (const int axis : {int(QwtPlot::xBottom), int(QwtPlot::yLeft)}) {
    QPalette palette = plot.axisWidget(axis)->palette();
    palette.setColor(QPalette::WindowText, ink.quiet);
    palette.setColor(QPalette::Text, ink.quiet);
    plot.axisWidget(axis)->setPalette(palette);
  }
  if (picture.categories.isEmpty()) {
    plot.setAxisAutoScale(QwtPlot::xBottom);
  } else {
    plot.setAxisScale(QwtPlot::xBottom, -0.5, picture.categories.size() - 0.5, 1);
  }
  plot.setAxisScaleDraw(QwtPlot::xBottom, new CountDraw(picture.categories));
  // Qwt asks only once how far labels extend beyond the ends of the axis, which depends on its length. With room for
  // half of the widest label at both ends the answer does not change, and boxes stay above their labels at any size.
  double widest = 0;
  for (const QString& name : picture.categories)
    widest =
        std::max(widest, QwtText(name, QwtText::PlainText).textSize(plot.axisWidget(QwtPlot::xBottom)->font()).width());
  const int room = int(std::ceil(widest / 2));
  plot.axisWidget(QwtPlot::xBottom)->setMinBorderDist(room, room);
}

QColor colorOf(ChartContents::Tone tone, const Ink& ink) {
  using enum ChartContents::Tone;
  return tone == Text      ? ink.text
         : tone == Quiet   ? ink.quiet
         : tone == Accent  ? ink.accent
         : tone == Good    ? ink.good
         : tone == Caution ? ink.caution
                           : ink.danger;
}

}  // namespace

void fillPlot(QwtPlot& plot, const ChartContents& picture, const Ink& ink) {
  plot.detachItems(QwtPlotItem::Rtti_PlotItem, true);
  plot.insertLegend(nullptr);
  setAxes(plot, picture, ink);
  auto* grid = new QwtPlotGrid;
  grid->enableX(false);
  grid->setPen(ink.grid, 0, Qt::DotLine);
  grid->attach(&plot);
  bool named = false;
  QRectF all;
  const auto attach = [&](Item* item) {
    all = all.isNull() ? item->boundingRect() : all.united(item->boundingRect());
    named = named || item->testItemAttribute(QwtPlotItem::Legend);
    item->setTitle(small(item->title().text(), ink.text));
    item->attach(&plot);
  };
  for (const auto& band : picture.bands) attach(new BandItem(band, colorOf(band.tone, ink)));
  for (const auto& box : picture.boxes) attach(new BoxItem(box, colorOf(box.tone, ink)));
  for (const auto& line : picture.lines) attach(new LineItem(line, colorOf(line.tone, ink)));
  // The first attempt has the number 1.
  if (picture.categories.isEmpty() && all.left() >= 0.5)
    plot.setAxisScale(QwtPlot::xBottom, 0.5, std::max(all.right(), 1.5));
  if (picture.y) {
    const double low = std::min(picture.y->low, all.top()), high = std::max(picture.y->high, all.bottom());
    plot.setAxisScale(QwtPlot::yLeft, low, high);
  } else {
    plot.setAxisAutoScale(QwtPlot::yLeft);
  }
  if (named) {
    auto* legend = new QwtLegend;
    QPalette palette = legend->palette();
    palette.setColor(QPalette::WindowText, ink.text);
    palette.setColor(QPalette::Text, ink.text);
    legend->setPalette(palette);
    plot.insertLegend(legend, QwtPlot::TopLegend);
  }
  plot.updateAxes();
  plot.replot();
}

}  // namespace insonate::ui
