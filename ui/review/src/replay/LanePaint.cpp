#include "LanePaint.h"

#include "../attempt/Words.h"

#include <insonate/ui/AttemptWords.h>
#include <insonate/ui/StateColors.h>
#include <insonate/ui/Text.h>
#include <insonate/ui/Theme.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace insonate::review {
namespace {

namespace theme = views::theme;
using ui::toQColor;

/// 1, 2 or 5 times a power of ten, at least `least`.
double roundStep(double least) {
  const double ten = std::pow(10, std::floor(std::log10(least)));
  for (const double step : {1.0, 2.0, 5.0})
    if (least <= step * ten) return step * ten;
  return 10 * ten;
}

/// Signs of the needle's place closer than this would overlap.
constexpr double kSignsApart_px = 16;

QFont smallFont(const QFont& font) {
  QFont small = font;
  small.setPointSizeF(font.pointSizeF() * 0.85);
  return small;
}

}  // namespace

LaneLayout::LaneLayout(int width_px, bool hasComments) {
  const int left = kNames_px, width = std::max(1, width_px - kNames_px - kRight_px);
  int top = 0;
  const auto next = [&](int height) {
    const QRect lane(left, top, width, height);
    top += height + kGap_px;
    return lane;
  };
  marks = next(kMarks_px);
  if (hasComments) comments = next(kComments_px);
  probe = next(kBar_px);
  depth = next(kDepth_px);
  aspirating = next(kBar_px);
  force = next(kForce_px);
  axis = next(kAxis_px);
}

LanePaint::LanePaint(QPainter& painter, const LaneLayout& layout, const AttemptDigest& attempt, std::int64_t first_us,
                     std::int64_t last_us)
    : painter_(painter), layout_(layout), attempt_(attempt), first_us_(first_us), last_us_(last_us) {}

double LanePaint::x(std::int64_t time_us) const {
  return layout_.axis.left() + double(time_us - first_us_) / double(last_us_ - first_us_) * layout_.axis.width();
}

void LanePaint::name(const QRect& lane, const QString& text) {
  painter_.setPen(toQColor(theme::kQuiet));
  painter_.drawText(QRect(0, lane.center().y() - 10, LaneLayout::kNames_px - 8, 20), Qt::AlignRight | Qt::AlignVCenter,
                    text);
}

void LanePaint::all() {
  painter_.setRenderHint(QPainter::Antialiasing);
  painter_.setFont(smallFont(painter_.font()));
  for (const QRect& lane : {layout_.probe, layout_.depth, layout_.aspirating, layout_.force})
    painter_.fillRect(lane, toQColor(theme::kGround));
  axis();
  bars(
      layout_.probe, [](const TrackPoint& p) { return p.probeOnSkin; }, theme::kAccent);
  bars(
      layout_.aspirating, [](const TrackPoint& p) { return p.aspirating; }, theme::kLink);
  depth();
  force();
  marks();
  name(layout_.marks, tr("moments"));
  name(layout_.probe, tr("probe on skin"));
  name(layout_.depth, tr("inserted, mm"));
  name(layout_.aspirating, tr("aspirating"));
  name(layout_.force, tr("probe, N"));
}

void LanePaint::bars(const QRect& lane, const std::function<bool(const TrackPoint&)>& on, views::Color fill) {
  const auto& track = attempt_.track;
  for (std::size_t i = 0; i < track.size();) {
    if (!on(track[i])) {
      ++i;
      continue;
    }
    std::size_t end = i;
    while (end < track.size() && on(track[end])) ++end;
    const double from = x(track[i].time_us), to = x(end < track.size() ? track[end].time_us : attempt_.end_us);
    painter_.setClipRect(lane);
    painter_.fillRect(QRectF(from, lane.top(), std::max(1.0, to - from), lane.height()), toQColor(fill));
    painter_.setClipping(false);
    i = end;
  }
}

/// Downwards, as in the image; in the color of the needle's place, with its sign where the place changes.
void LanePaint::depth() {
  const QRect lane = layout_.depth;
  double max_mm = 10;
  for (const TrackPoint& point : attempt_.track) max_mm = std::max(max_mm, point.needleDepth_mm.value_or(0));
  max_mm = std::ceil(max_mm / 10) * 10;
  painter_.setClipRect(lane);
  const auto y = [&](double depth_mm) { return lane.top() + 1 + depth_mm / max_mm * (lane.height() - 2); };
  std::optional<NeedlePlace> signedPlace;
  double sign_px = lane.left() - kSignsApart_px;
  for (std::size_t i = 1; i < attempt_.track.size(); ++i) {
    const TrackPoint &a = attempt_.track[i - 1], &b = attempt_.track[i];
    if (!a.needleDepth_mm || !b.needleDepth_mm || b.time_us < first_us_ || a.time_us > last_us_) continue;
    painter_.setPen(QPen(toQColor(ui::colorOf(b.place)), 1.8));
    painter_.drawLine(QPointF(x(a.time_us), y(*a.needleDepth_mm)), QPointF(x(b.time_us), y(*b.needleDepth_mm)));
    if (b.place == signedPlace || x(b.time_us) - sign_px < kSignsApart_px) continue;
    signedPlace = b.place;
    sign_px = x(b.time_us);
    const double least = lane.top() + painter_.fontMetrics().ascent();
    painter_.drawText(QPointF(sign_px + 2, std::max(least, y(*b.needleDepth_mm) - 4)), ui::displayText(b.place).sign);
  }
  painter_.setClipping(false);
  painter_.setPen(toQColor(theme::kQuiet));
  painter_.drawText(lane.adjusted(4, 0, 0, 0), Qt::AlignLeft | Qt::AlignTop, QStringLiteral("0"));
  painter_.drawText(lane.adjusted(4, 0, 0, 0), Qt::AlignLeft | Qt::AlignBottom, QString::number(max_mm));
}

void LanePaint::force() {
  const QRect lane = layout_.force;
  double max_N = 2;
  for (const TrackPoint& point : attempt_.track) max_N = std::max(max_N, point.probeForce_N);
  max_N = roundStep(max_N);
  painter_.setClipRect(lane);
  QPolygonF line;
  for (const TrackPoint& point : attempt_.track)
    line << QPointF(x(point.time_us), lane.bottom() - point.probeForce_N / max_N * (lane.height() - 2));
  painter_.setPen(QPen(toQColor(theme::kAccent), 1.4));
  painter_.drawPolyline(line);
  painter_.setClipping(false);
  painter_.setPen(toQColor(theme::kQuiet));
  painter_.drawText(lane.adjusted(4, 0, 0, 0), Qt::AlignLeft | Qt::AlignTop, QString::number(max_N));
}

void LanePaint::axis() {
  constexpr double kLeast_px = 70;
  double step_s = roundStep(kLeast_px * double(last_us_ - first_us_) * 1e-6 / layout_.axis.width());
  if (step_s > 10) step_s = std::ceil(step_s / 30) * 30;
  for (double s = std::ceil(double(first_us_) * 1e-6 / step_s) * step_s; s * 1e6 <= double(last_us_); s += step_s) {
    const double at = x(std::int64_t(s * 1e6));
    painter_.setPen(toQColor(theme::kLine));
    painter_.drawLine(QPointF(at, layout_.probe.top()), QPointF(at, layout_.axis.top()));
    painter_.setPen(toQColor(theme::kQuiet));
    const QString text = clockOf(std::int64_t(s * 1e6));
    painter_.drawText(QRectF(at - 40, layout_.axis.top(), 80, layout_.axis.height()), Qt::AlignHCenter | Qt::AlignTop,
                      step_s < 1 ? text : text.left(text.indexOf(QLatin1Char('.'))));
  }
}

void LanePaint::marks() {
  const auto paint = [&](bool wrong) {
    for (const AttemptMoment& moment : attempt_.moments)
      if (moment.severity.has_value() == wrong && moment.time_us >= first_us_ && moment.time_us <= last_us_) {
        const QPointF at(x(moment.time_us), layout_.marks.center().y());
        painter_.setPen(QPen(toQColor(ui::colorOf(moment.severity)), 1, Qt::DotLine));
        if (wrong) painter_.drawLine(QPointF(at.x(), layout_.marks.bottom()), QPointF(at.x(), layout_.axis.top()));
        paintMark(painter_, at, moment.severity);
      }
  };
  // Errors are drawn over other events.
  paint(false);
  paint(true);
}

void LanePaint::comments(const std::vector<TimelineComment>& comments) {
  for (const TimelineComment& one : comments)
    if (one.time_us >= first_us_ && one.time_us <= last_us_)
      paintComment(painter_, {x(one.time_us), layout_.comments.center().y() + 0.0}, one.isUnread);
  name(layout_.comments, tr("comments"));
}

void paintComment(QPainter& painter, QPointF middle, bool isUnread) {
  const double x = middle.x(), y = middle.y();
  painter.setPen(QPen(toQColor(theme::kLink), 1.4));
  painter.setBrush(isUnread ? QBrush(toQColor(theme::kLink)) : QBrush(Qt::NoBrush));
  // The tip of the balloon's tail is at the comment's time.
  painter.drawPolygon(QPolygonF(
      {{x - 6, y - 7}, {x + 6, y - 7}, {x + 6, y + 2}, {x + 2, y + 2}, {x, y + 7}, {x - 2, y + 2}, {x - 6, y + 2}}));
  painter.setBrush(Qt::NoBrush);
  if (!isUnread) return;
  painter.setPen(Qt::NoPen);
  painter.setBrush(toQColor(theme::kBlack));
  painter.drawEllipse(QPointF(x, y - 2.5), 2, 2);
  painter.setBrush(Qt::NoBrush);
}

void paintMark(QPainter& painter, QPointF middle, const std::optional<Severity>& severity) {
  painter.setPen(QPen(toQColor(theme::kPanel), 1));
  painter.setBrush(toQColor(ui::colorOf(severity)));
  const double x = middle.x(), y = middle.y();
  if (!severity) {
    painter.drawEllipse(middle, 3.5, 3.5);
  } else if (*severity == Severity::Minor) {
    painter.drawRect(QRectF(x - 4.5, y - 4.5, 9, 9));
  } else if (*severity == Severity::Major) {
    painter.drawPolygon(QPolygonF({{x, y - 7}, {x + 7, y}, {x, y + 7}, {x - 7, y}}));
  } else {
    painter.drawPolygon(QPolygonF({{x, y - 8}, {x + 8.5, y + 7}, {x - 8.5, y + 7}}));
    painter.setPen(QPen(toQColor(theme::kBlack), 1.6));
    painter.drawLine(QPointF(x, y - 2.5), QPointF(x, y + 2));
    painter.drawPoint(QPointF(x, y + 4.8));
  }
  painter.setBrush(Qt::NoBrush);
}

}  // namespace insonate::review
