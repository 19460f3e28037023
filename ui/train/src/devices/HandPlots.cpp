#include "HandPlots.h"

#include <insonate/ui/Theme.h>
#include <insonate/views/Theme.h>

#include <qwt_legend.h>
#include <qwt_plot.h>
#include <qwt_plot_canvas.h>
#include <qwt_plot_grid.h>
#include <qwt_plot_item.h>
#include <qwt_scale_map.h>

#include <QHBoxLayout>
#include <QPainter>
#include <QPen>
#include <QPolygonF>
#include <algorithm>
#include <cmath>

namespace insonate::train {
namespace {

constexpr double kUsualForce_N = 4, kUsualRate_Hz = 1200;
constexpr views::Color kColors[] = {views::theme::kAccent, views::theme::kCaution};

QwtText small(const QString& words) {
  QwtText text(words);
  QFont font;
  font.setPointSizeF(font.pointSizeF() * 0.9);
  text.setFont(font);
  text.setColor(ui::toQColor(views::theme::kQuiet));
  return text;
}

/// 1, 2 or 5 times a power of ten, not below `value`.
double round(double value) {
  const double ten = std::pow(10, std::floor(std::log10(value)));
  for (const double step : {1.0, 2.0, 5.0})
    if (value <= step * ten) return step * ten;
  return 10 * ten;
}

}  // namespace

/// One line of a plot. QwtPlotCurve's headers are no C++20 (Qwt 6.1).
class HandPlots::Trace final : public QwtPlotItem {
 public:
  Trace(const QString& name, const QPen& pen) : QwtPlotItem(QwtText(name)), pen_(pen) {
    setItemAttribute(QwtPlotItem::Legend);
    setRenderHint(QwtPlotItem::RenderAntialiased);
  }
  void set(QPolygonF points) { points_ = std::move(points); }
  void draw(QPainter* painter, const QwtScaleMap& x, const QwtScaleMap& y, const QRectF&) const override {
    QPolygonF line;
    for (const QPointF& p : points_) line << QPointF(x.transform(p.x()), y.transform(p.y()));
    painter->setPen(pen_);
    painter->drawPolyline(line);
  }
  QwtGraphic legendIcon(int, const QSizeF&) const override {
    QwtGraphic icon;
    icon.setDefaultSize({24, 8});
    QPainter painter(&icon);
    painter.setPen(pen_);
    painter.drawLine(0, 4, 24, 4);
    return icon;
  }

 private:
  QPen pen_;
  QPolygonF points_;
};

HandPlots::HandPlots(QWidget* parent) : QWidget(parent) {
  setObjectName("handPlots");
  auto* box = new QHBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(ui::kGap);
  force_ = make("forcePlot", tr("force, N"), kUsualForce_N);
  rate_ = make("ratePlot", tr("updates/s"), kUsualRate_Hz);
  box->addWidget(force_.plot);
  box->addWidget(rate_.plot);
  clock_.start();
}

HandPlots::Shown HandPlots::make(const char* object, const QString& title, double usual) {
  Shown shown;
  auto* plot = shown.plot = new QwtPlot(this);
  plot->setObjectName(QLatin1String(object));
  plot->setMinimumSize(260, 150);
  plot->setAccessibleName(title);
  plot->setToolTip(tr("%1 of both hands over the last 10 seconds").arg(title));
  auto* canvas = new QwtPlotCanvas(plot);
  canvas->setFrameStyle(QFrame::NoFrame);
  canvas->setPalette(ui::toQColor(views::theme::kGround));
  plot->setCanvas(canvas);
  plot->setAxisTitle(QwtPlot::yLeft, small(title));
  plot->setAxisTitle(QwtPlot::xBottom, small(tr("s")));
  plot->setAxisScale(QwtPlot::xBottom, -kLast_s, 0);
  plot->setAxisScale(QwtPlot::yLeft, 0, usual);
  plot->setAxisMaxMajor(QwtPlot::yLeft, 4);  // more would run into each other
  plot->setAxisMaxMinor(QwtPlot::yLeft, 0);
  plot->insertLegend(new QwtLegend, QwtPlot::TopLegend);
  auto* grid = new QwtPlotGrid;
  grid->setPen(ui::toQColor(views::theme::kLine), 0, Qt::DotLine);
  grid->attach(plot);
  const QString names[] = {tr("probe"), tr("needle")};
  for (int hand = 0; hand < 2; ++hand) {
    // Told apart by more than colour.
    const QPen pen(ui::toQColor(kColors[hand]), 1.6, hand == 0 ? Qt::SolidLine : Qt::DashLine);
    shown.traces[hand] = new Trace(names[hand], pen);
    shown.traces[hand]->attach(plot);
  }
  return shown;
}

void HandPlots::show(Shown& shown, double usual) {
  double most = 0;
  for (int hand = 0; hand < 2; ++hand) {
    QPolygonF points;
    for (std::size_t i = 0; i < times_s_.size(); ++i)
      if (const double value = shown.values[hand][i]; value >= 0) {
        points << QPointF(times_s_[i] - times_s_.back(), value);
        most = std::max(most, value);
      }
    shown.traces[hand]->set(std::move(points));
  }
  shown.plot->setAxisScale(QwtPlot::yLeft, 0, most > usual ? round(most) : usual);
  shown.plot->replot();
}

void HandPlots::add(const std::array<double, 2>& force_N, const std::array<double, 2>& rate_Hz) {
  const double now_s = double(clock_.elapsed()) / 1000;
  times_s_.push_back(now_s);
  for (int hand = 0; hand < 2; ++hand) {
    force_.values[hand].push_back(force_N[hand]);
    rate_.values[hand].push_back(rate_Hz[hand]);
  }
  const auto old = std::ranges::find_if(times_s_, [&](double t) { return t >= now_s - kLast_s; }) - times_s_.begin();
  times_s_.erase(times_s_.begin(), times_s_.begin() + old);
  for (Shown* shown : {&force_, &rate_})
    for (auto& values : shown->values) values.erase(values.begin(), values.begin() + old);
  show(force_, kUsualForce_N);
  show(rate_, kUsualRate_Hz);
}

}  // namespace insonate::train
