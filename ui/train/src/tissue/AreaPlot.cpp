#include "AreaPlot.h"

#include "VesselAreas.h"

#include <insonate/simulator/LiveImaging.h>
#include <insonate/tissue/Labels.h>
#include <insonate/ui/Theme.h>

#include <QPainter>
#include <algorithm>
#include <cmath>

namespace insonate::train {
namespace {

constexpr double kLeft = 46, kRight = 14, kTop = 24, kBottom = 34;
constexpr double kForces_N[] = {2, 5, 10, 20, 50, 100};
constexpr double kAreaStep = 40;

}  // namespace

AreaPlot::AreaPlot(QWidget* parent) : QWidget(parent) {
  setObjectName("areaPlot");
  setToolTip(
      tr("Areas of vein and artery in the image plane, in % of their areas in the CT, against the force of the probe "
         "in N.\nDots: values since the curve was cleared; rings: present values."));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  trace_.reserve(kMost);
  describe();
}

AreaPlot::Point AreaPlot::pointOf(const LiveDeformation& press) {
  const auto share = [&](Label label) {
    const LumenArea* area = lumenOf(press, label);
    return area ? float(100 * area->area_mm2 / area->rest_mm2) : -1;
  };
  return {float(std::max(0.0, press.force_N)), share(kVein), share(kArtery)};
}

void AreaPlot::grow(const Point& point) {
  for (double most : kForces_N)
    if (maxForce_N_ < point.force_N && most >= point.force_N) maxForce_N_ = most;
  const double area = std::max(point.vein, point.artery);
  if (area > maxArea_) maxArea_ = kAreaStep * std::ceil(area / kAreaStep);
}

void AreaPlot::add(const LiveDeformation& press) {
  show(press);
  if (!presses(press) || (now_.vein < 0 && now_.artery < 0)) return;
  if (now_.force_N > maxForce_N_) return;
  if (trace_.size() < kMost)
    trace_.push_back(now_);
  else
    trace_[next_] = now_;
  next_ = (next_ + 1) % kMost;
}

void AreaPlot::show(const LiveDeformation& press) {
  now_ = pointOf(press);
  // A model on its way may be far off for an image: no reason for another scale.
  if (press.settled) grow(now_);
  describe();
  update();
}

void AreaPlot::clear() {
  trace_.clear();
  next_ = 0;
  now_ = {};
  maxForce_N_ = 2, maxArea_ = 120;
  describe();
  update();
}

void AreaPlot::describe() {
  QString words = tr("Area of each vessel in percent of its area in the CT, against force.");
  if (now_.vein >= 0) words += tr(" Vein %1 percent.").arg(now_.vein, 0, 'f', 0);
  if (now_.artery >= 0) words += tr(" Artery %1 percent.").arg(now_.artery, 0, 'f', 0);
  if (now_.vein >= 0 || now_.artery >= 0) words += tr(" Force %1 newtons.").arg(now_.force_N, 0, 'f', 1);
  setAccessibleName(words);
}

QPointF AreaPlot::at(const QRectF& room, double force_N, double area) const {
  return {room.left() + room.width() * std::min(1.0, force_N / maxForce_N_),
          room.bottom() - room.height() * std::min(1.0, area / maxArea_)};
}

void AreaPlot::drawAxes(QPainter& painter, const QRectF& room) const {
  const QColor line = ui::toQColor(views::theme::kLine), quiet = ui::toQColor(views::theme::kQuiet);
  QFont font = painter.font();
  font.setPointSizeF(font.pointSizeF() - 1);
  painter.setFont(font);
  for (double area = 0; area <= maxArea_ + 1e-6; area += kAreaStep) {
    const QPointF from = at(room, 0, area);
    painter.setPen(line);
    painter.drawLine(from, {room.right(), from.y()});
    painter.setPen(quiet);
    painter.drawText(QRectF(0, from.y() - 8, kLeft - 6, 16), Qt::AlignRight | Qt::AlignVCenter,
                     area > 0 ? tr("%1 %").arg(area) : QStringLiteral("0"));
  }
  for (int k = 0; k <= 4; ++k) {
    const double force_N = maxForce_N_ * k / 4;
    const QPointF foot = at(room, force_N, 0);
    painter.setPen(quiet);
    painter.drawText(QRectF(foot.x() - 24, room.bottom() + 3, 48, 14), Qt::AlignHCenter | Qt::AlignTop,
                     QString::number(force_N));
  }
  painter.drawText(QRectF(room.left(), room.bottom() + 16, room.width(), 16), Qt::AlignHCenter | Qt::AlignTop,
                   tr("force in N"));
  painter.drawText(QRectF(2, 2, width() - 4, 16), Qt::AlignLeft | Qt::AlignTop,
                   tr("vessel area, % of its area in the CT"));
}

void AreaPlot::drawVessel(QPainter& painter, const QRectF& room, float Point::*area, const QColor& color) const {
  painter.setPen(Qt::NoPen);
  QColor faint = color;
  faint.setAlpha(110);
  painter.setBrush(faint);
  for (const Point& point : trace_)
    if (point.*area >= 0) painter.drawEllipse(at(room, point.force_N, point.*area), 1.5, 1.5);
  if (now_.*area < 0) return;
  painter.setBrush(ui::toQColor(views::theme::kPanel));
  painter.setPen(QPen(color, 2));
  painter.drawEllipse(at(room, now_.force_N, now_.*area), 5, 5);
}

void AreaPlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), ui::toQColor(views::theme::kPanel));
  const QRectF room(kLeft, kTop, std::max(10.0, width() - kLeft - kRight), std::max(10.0, height() - kTop - kBottom));
  drawAxes(painter, room);
  const QColor vein = vesselColor(kVein), artery = vesselColor(kArtery);
  drawVessel(painter, room, &Point::vein, vein);
  drawVessel(painter, room, &Point::artery, artery);
  if (now_.vein >= 0 || now_.artery >= 0 || !trace_.empty()) return;
  painter.setPen(ui::toQColor(views::theme::kQuiet));
  painter.drawText(room, Qt::AlignCenter | Qt::TextWordWrap, tr("Compress a vessel with + and -"));
}

}  // namespace insonate::train
