#include "Timeline.h"

#include "../ReviewSession.h"
#include "../attempt/Words.h"

#include <insonate/ui/AttemptWords.h>
#include <insonate/ui/PlainToolTip.h>
#include <insonate/ui/Theme.h>

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

namespace insonate::review {
namespace {

constexpr int kMomentMark_px = 8;
constexpr double kZoom = 0.8, kNotch = 120, kLeast_us = 1e6;

}  // namespace

Timeline::Timeline(ReviewSession& session, QWidget* parent) : QWidget(parent), session_(session) {
  setObjectName(QStringLiteral("timeline"));
  setAccessibleName(tr("Timeline of the attempt"));
  setToolTip(tr("Click or drag to go to a time; the wheel zooms, a double click shows the whole attempt"));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setFixedHeight(layout().height_px());
  connect(&session_, &ReviewSession::attemptChanged, this, [this] { showAll(); });
  connect(&session_, &ReviewSession::timeChanged, this, [this] {
    follow();
    update();
  });
}

QSize Timeline::sizeHint() const {
  return {800, layout().height_px()};
}

void Timeline::showAll() {
  setRange(0, session_.attempt() ? double(session_.attempt()->end_us) : 0);
}

void Timeline::setRange(double first_us, double last_us) {
  const double end_us = session_.attempt() ? double(session_.attempt()->end_us) : 0;
  const double length_us = std::min(end_us, std::max(last_us - first_us, std::min(kLeast_us, end_us)));
  const double first = std::clamp(first_us, 0.0, end_us - length_us);
  first_us_ = std::int64_t(first), last_us_ = std::int64_t(first + length_us);
  lanes_ = {};
  update();
}

/// Scrolls a zoomed view with the time.
void Timeline::follow() {
  const std::int64_t now_us = session_.time_us();
  if (dragging_ || (now_us >= first_us_ && now_us <= last_us_)) return;
  const double length_us = double(last_us_ - first_us_);
  setRange(double(now_us) - length_us * 0.1, double(now_us) + length_us * 0.9);
}

int Timeline::xOf(std::int64_t time_us) const {
  const QRect axis = layout().axis;
  if (last_us_ <= first_us_) return axis.left();
  return axis.left() + int(std::lround(double(time_us - first_us_) / double(last_us_ - first_us_) * axis.width()));
}

std::int64_t Timeline::timeAt(int x) const {
  const QRect axis = layout().axis;
  return first_us_ + std::int64_t(double(x - axis.left()) / axis.width() * double(last_us_ - first_us_));
}

int Timeline::momentAt(QPoint at) const {
  if (!session_.attempt() || at.y() > LaneLayout::kMarks_px) return -1;
  int nearest = -1, least = kMomentMark_px + 1;
  const auto& moments = session_.attempt()->moments;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const int off = std::abs(xOf(moments[i].time_us) - at.x());
    // Errors come first among moments at the same place.
    if (off < least || (off == least && nearest >= 0 && moments[i].severity)) least = off, nearest = int(i);
  }
  return nearest;
}

int Timeline::commentAt(QPoint at) const {
  const QRect lane = layout().comments;
  if (lane.isNull() || at.y() < lane.top() || at.y() > lane.bottom()) return -1;
  int nearest = -1, least = kMomentMark_px + 1;
  for (std::size_t i = 0; i < comments_.size(); ++i)
    if (const int off = std::abs(xOf(comments_[i].time_us) - at.x()); off < least) least = off, nearest = int(i);
  return nearest;
}

void Timeline::setComments(std::vector<TimelineComment> comments) {
  comments_ = std::move(comments);
  setFixedHeight(layout().height_px());
  lanes_ = {};
  update();
}

/// Time of the mark at this point.
std::optional<std::int64_t> Timeline::markAt(QPoint at) const {
  if (const int moment = momentAt(at); moment >= 0) return session_.attempt()->moments[std::size_t(moment)].time_us;
  if (const int comment = commentAt(at); comment >= 0) return comments_[std::size_t(comment)].time_us;
  return std::nullopt;
}

QString Timeline::wordsAt(QPoint at) const {
  if (const int number = commentAt(at); number >= 0) {
    const TimelineComment& comment = comments_[std::size_t(number)];
    return ui::plainToolTip(tr("%1  %2").arg(clockOf(comment.time_us), comment.words));
  }
  const int number = momentAt(at);
  if (number < 0) return toolTip();
  const AttemptMoment& moment = session_.attempt()->moments[std::size_t(number)];
  const QString words = tr("%1  %2").arg(clockOf(moment.time_us), QString::fromStdString(moment.description));
  return moment.severity ? words + tr(" (%1)").arg(ui::nameOf(*moment.severity)) : words;
}

void Timeline::paintLanes() {
  const double ratio = devicePixelRatioF();
  lanes_ = QPixmap(size() * ratio);
  lanes_.setDevicePixelRatio(ratio);
  lanes_.fill(ui::toQColor(views::theme::kPanel));
  QPainter painter(&lanes_);
  painter.setFont(font());
  const LaneLayout lanes = layout();
  LanePaint paint(painter, lanes, *session_.attempt(), first_us_, last_us_);
  paint.all();
  if (!comments_.empty()) paint.comments(comments_);
}

void Timeline::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (!session_.attempt() || last_us_ <= first_us_) {
    painter.fillRect(rect(), ui::toQColor(views::theme::kPanel));
    return;
  }
  if (lanes_.isNull()) paintLanes();
  painter.drawPixmap(0, 0, lanes_);
  const QRect axis = layout().axis;
  const int x = xOf(session_.time_us());
  if (x < axis.left() || x > axis.right() + 1) return;
  painter.setPen(QPen(ui::toQColor(views::theme::kText), hasFocus() ? 2 : 1));
  painter.drawLine(x, 0, x, axis.top());
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(ui::toQColor(hasFocus() ? views::theme::kAccent : views::theme::kText));
  painter.setPen(Qt::NoPen);
  const double y = axis.top();
  painter.drawPolygon(QPolygonF({QPointF(x, y - 6), QPointF(x + 5.5, y + 3), QPointF(x - 5.5, y + 3)}));
}

void Timeline::resizeEvent(QResizeEvent*) {
  lanes_ = {};
}

void Timeline::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !session_.attempt()) return;
  session_.setPlaying(false);
  if (const auto time_us = markAt(event->pos())) return session_.setTime(*time_us);
  dragging_ = true;
  session_.setTime(timeAt(event->x()));
}

void Timeline::mouseMoveEvent(QMouseEvent* event) {
  if (dragging_) return session_.setTime(timeAt(event->x()));
  setCursor(markAt(event->pos()) ? Qt::PointingHandCursor : Qt::ArrowCursor);
}

void Timeline::mouseReleaseEvent(QMouseEvent*) {
  dragging_ = false;
}

void Timeline::mouseDoubleClickEvent(QMouseEvent*) {
  showAll();
}

void Timeline::wheelEvent(QWheelEvent* event) {
  const QPoint turned = event->angleDelta();
  const double length_us = double(last_us_ - first_us_), notches = (turned.y() ? turned.y() : turned.x()) / kNotch;
  if (event->modifiers().testFlag(Qt::ShiftModifier) || turned.y() == 0)
    return setRange(double(first_us_) - notches * length_us / 10, double(last_us_) - notches * length_us / 10);
  const double pointed_us = double(timeAt(int(event->position().x()))), factor = std::pow(kZoom, notches);
  setRange(pointed_us - (pointed_us - double(first_us_)) * factor,
           pointed_us + (double(last_us_) - pointed_us) * factor);
}

bool Timeline::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    auto* help = static_cast<QHelpEvent*>(event);
    QToolTip::showText(help->globalPos(), wordsAt(help->pos()), this);
    return true;
  }
  return QWidget::event(event);
}

}  // namespace insonate::review
