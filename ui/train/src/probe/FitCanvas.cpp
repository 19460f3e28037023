#include "FitCanvas.h"

#include <insonate/ui/Theme.h>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace insonate::train {
namespace {

constexpr double kRadians = std::numbers::pi / 180;
constexpr double kCatch_px = 14, kHandle_px = 6;
constexpr double kLeast_px = 10;
using Handle = FitCanvas::Handle;
constexpr Handle kHandles[] = {Handle::Left, Handle::Right,      Handle::Face,
                               Handle::End,  Handle::LeftCorner, Handle::RightCorner};

PixelPoint pointOf(const FovShape& shape, Handle handle) {
  switch (handle) {
    case Handle::Left:
      return pointAtFraction(shape, -1, 0.5);
    case Handle::Right:
      return pointAtFraction(shape, 1, 0.5);
    case Handle::Face:
      return pointAtFraction(shape, 0, 0);
    case Handle::End:
      return pointAtFraction(shape, 0, 1);
    case Handle::LeftCorner:
      return pointAtFraction(shape, -1, 1);
    case Handle::RightCorner:
      return pointAtFraction(shape, 1, 1);
    default:
      return pointAtFraction(shape, 0, 0.5);
  }
}

/// Across and down from the origin, along the axis.
PixelPoint localOf(const FovShape& shape, PixelPoint p) {
  const double t = shape.rotation_deg * kRadians, dx = p.x - shape.origin.x;
  const double dy = (p.y - shape.origin.y) * (shape.upsideDown ? -1 : 1);
  return {std::cos(t) * dx - std::sin(t) * dy, std::sin(t) * dx + std::cos(t) * dy};
}

void moveOrigin(FovShape& shape, double across, double down) {
  const double t = shape.rotation_deg * kRadians;
  const double dy = -std::sin(t) * across + std::cos(t) * down;
  shape.origin.x += std::cos(t) * across + std::sin(t) * down;
  shape.origin.y += shape.upsideDown ? -dy : dy;
}

/// One side of a fan to an angle; of a rectangle to a place. The other one stays.
void moveSide(FovShape& shape, bool right, PixelPoint local) {
  const double sign = right ? 1 : -1;
  if (shape.shape == ProbeShape::Linear) {
    const double grown = sign * local.x - shape.width_px / 2;
    const double width = std::max(kLeast_px, shape.width_px + grown);
    moveOrigin(shape, sign * (width - shape.width_px) / 2, 0);
    shape.width_px = width;
    return;
  }
  const double grown = sign * std::atan2(local.x, local.y) / kRadians - shape.alpha_deg / 2;
  const double alpha = std::clamp(shape.alpha_deg + grown, 5.0, 175.0);
  shape.rotation_deg += sign * (alpha - shape.alpha_deg) / 2;
  shape.alpha_deg = alpha;
}

void moveEnd(FovShape& shape, PixelPoint local) {
  if (shape.shape == ProbeShape::Linear)
    shape.depth_px = std::max(kLeast_px, local.y);
  else
    shape.r2_px = std::max(shape.r1_px + kLeast_px, std::hypot(local.x, local.y));
}

void moveFace(FovShape& shape, PixelPoint local) {
  if (shape.shape != ProbeShape::Linear) {
    shape.r1_px = std::clamp(local.y, 0.0, shape.r2_px - kLeast_px);
    return;
  }
  const double down = std::min(local.y, shape.depth_px - kLeast_px);
  moveOrigin(shape, 0, down);
  shape.depth_px -= down;
}

}  // namespace

FovShape draggedTo(FovShape shape, FitCanvas::Handle handle, PixelPoint to, PixelPoint from) {
  const PixelPoint local = localOf(shape, to);
  switch (handle) {
    case Handle::Left:
    case Handle::Right:
      moveSide(shape, handle == Handle::Right, local);
      break;
    case Handle::LeftCorner:
    case Handle::RightCorner:
      moveSide(shape, handle == Handle::RightCorner, local);
      moveEnd(shape, local);
      break;
    case Handle::Face:
      moveFace(shape, local);
      break;
    case Handle::End:
      moveEnd(shape, local);
      break;
    case Handle::Whole:
      shape.origin.x += to.x - from.x, shape.origin.y += to.y - from.y;
      break;
    case Handle::None:
      break;
  }
  return shape;
}

FitCanvas::FitCanvas(QWidget* parent) : QWidget(parent) {
  setObjectName("fitCanvas");
  setMinimumSize(360, 280);
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Scanner image with the outline of the field of view"));
  setToolTip(
      tr("Drag a side, a corner, the face or the bottom of the outline; drag inside to move the whole outline.\nKeys: "
         "G selects the next handle, arrow keys move it."));
}

void FitCanvas::setPicture(const QImage& picture) {
  picture_ = picture;
  update();
}
void FitCanvas::setShape(const std::optional<FovShape>& shape) {
  shape_ = shape;
  update();
}
void FitCanvas::setMarks(std::vector<PixelPoint> marks) {
  marks_ = std::move(marks);
  update();
}
void FitCanvas::setLine(const std::optional<Line>& line) {
  line_ = line;
  update();
}
void FitCanvas::setDrawing(bool drawing) {
  drawing_ = drawing;
  begun_ = false;
  setCursor(drawing ? Qt::CrossCursor : Qt::ArrowCursor);
}
void FitCanvas::setInvitation(const QString& text) {
  invitation_ = text;
  update();
}

double FitCanvas::scale() const {
  if (picture_.isNull()) return 1;
  return std::min((width() - 32.0) / picture_.width(), (height() - 32.0) / picture_.height());
}
QPointF FitCanvas::widgetFrom(PixelPoint p) const {
  const double s = scale();
  return {width() / 2.0 + (p.x + 0.5 - picture_.width() / 2.0) * s,
          height() / 2.0 + (p.y + 0.5 - picture_.height() / 2.0) * s};
}
PixelPoint FitCanvas::pictureFrom(QPointF p) const {
  const double s = scale();
  return {(p.x() - width() / 2.0) / s + picture_.width() / 2.0 - 0.5,
          (p.y() - height() / 2.0) / s + picture_.height() / 2.0 - 0.5};
}

QPointF FitCanvas::placeOf(Handle handle) const {
  return shape_ ? widgetFrom(pointOf(*shape_, handle)) : QPointF();
}

void FitCanvas::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), Qt::black);
  if (picture_.isNull()) {
    painter.setPen(ui::toQColor(views::theme::kQuiet));
    painter.drawText(rect().adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap, invitation_);
    return;
  }
  painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
  const QPointF corner = widgetFrom({-0.5, -0.5});
  painter.drawImage(QRectF(corner, QSizeF(picture_.width() * scale(), picture_.height() * scale())), picture_);
  paintLine(painter);
  if (!shape_) return;
  QPainterPath outline;
  for (const PixelPoint& p : outlineOf(*shape_)) {
    const QPointF at = widgetFrom(p);
    outline.elementCount() == 0 ? outline.moveTo(at) : outline.lineTo(at);
  }
  outline.closeSubpath();
  painter.setPen(QPen(QColor(0, 0, 0, 160), 3.5));
  painter.drawPath(outline);
  painter.setPen(QPen(ui::toQColor(views::theme::kAccent), 1.5));
  painter.drawPath(outline);
  painter.setPen(QPen(ui::toQColor(views::theme::kCaution), 2));
  for (const PixelPoint& mark : marks_)
    painter.drawLine(widgetFrom(mark) - QPointF(7, 0), widgetFrom(mark) + QPointF(7, 0));
  for (const Handle handle : kHandles) {
    painter.setPen(QPen(Qt::black, 1.5));
    painter.setBrush(ui::toQColor(handle == chosen_ ? views::theme::kText : views::theme::kAccent));
    painter.drawEllipse(placeOf(handle), kHandle_px, kHandle_px);
  }
  if (hasFocus()) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(ui::toQColor(views::theme::kAccent));
    painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
  }
}

void FitCanvas::paintLine(QPainter& painter) const {
  if (!line_) return;
  const QPointF from = widgetFrom((*line_)[0]), to = widgetFrom((*line_)[1]);
  for (const auto& pen : {QPen(QColor(0, 0, 0, 160), 4), QPen(ui::toQColor(views::theme::kCaution), 1.5)}) {
    painter.setPen(pen);
    painter.drawLine(from, to);
    for (const QPointF& end : {from, to}) {
      painter.drawLine(end - QPointF(6, 0), end + QPointF(6, 0));
      painter.drawLine(end - QPointF(0, 6), end + QPointF(0, 6));
    }
  }
}

void FitCanvas::endLine(QPointF at) {
  (*line_)[1] = pictureFrom(at);
  setDrawing(false);
  update();
  Q_EMIT lineDrawn();
}

FitCanvas::Handle FitCanvas::nearest(QPointF at) const {
  if (!shape_) return Handle::None;
  Handle best = Handle::None;
  double least = kCatch_px;
  for (const Handle handle : kHandles) {
    const QPointF by = placeOf(handle) - at;
    if (const double far = std::hypot(by.x(), by.y()); far < least) least = far, best = handle;
  }
  if (best != Handle::None) return best;
  QPolygonF inside;
  for (const PixelPoint& p : outlineOf(*shape_)) inside << widgetFrom(p);
  return inside.containsPoint(at, Qt::OddEvenFill) ? Handle::Whole : Handle::None;
}

void FitCanvas::drag(Handle handle, PixelPoint to, PixelPoint from) {
  if (!shape_) return;
  shape_ = draggedTo(*shape_, handle, to, from);
  update();
  Q_EMIT shapeChanged();
}

void FitCanvas::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  if (drawing_) {
    if (begun_) return endLine(event->localPos());
    pressedAt_ = event->localPos();
    const PixelPoint from = pictureFrom(pressedAt_);
    line_ = Line{from, from};
    begun_ = true;
    return update();
  }
  chosen_ = nearest(event->localPos());
  held_ = chosen_ != Handle::None;
  last_ = pictureFrom(event->localPos());
  update();
}

void FitCanvas::mouseMoveEvent(QMouseEvent* event) {
  if (drawing_) {
    if (begun_) (*line_)[1] = pictureFrom(event->localPos());
    return update();
  }
  if (!held_) {
    const Handle handle = nearest(event->localPos());
    setCursor(handle == Handle::None    ? Qt::ArrowCursor
              : handle == Handle::Whole ? Qt::OpenHandCursor
                                        : Qt::SizeAllCursor);
    return;
  }
  const PixelPoint to = pictureFrom(event->localPos());
  drag(chosen_, to, last_);
  last_ = to;
}

void FitCanvas::mouseReleaseEvent(QMouseEvent* event) {
  constexpr double kDragged_px = 6;
  const QPointF by = event->localPos() - pressedAt_;
  if (drawing_ && begun_ && std::hypot(by.x(), by.y()) > kDragged_px) return endLine(event->localPos());
  held_ = false;
}

void FitCanvas::keyPressEvent(QKeyEvent* event) {
  const double by = event->modifiers() & Qt::ShiftModifier ? 10 : 1;
  double dx = 0, dy = 0;
  switch (event->key()) {
    case Qt::Key_G:
      chosen_ = Handle((int(chosen_) + 1) % (int(Handle::Whole) + 1));
      return update();
    case Qt::Key_Left:
      dx = -by;
      break;
    case Qt::Key_Right:
      dx = by;
      break;
    case Qt::Key_Up:
      dy = -by;
      break;
    case Qt::Key_Down:
      dy = by;
      break;
    default:
      return QWidget::keyPressEvent(event);
  }
  if (!shape_ || chosen_ == Handle::None) return;
  const PixelPoint from = pointOf(*shape_, chosen_);
  drag(chosen_, {from.x + dx, from.y + dy}, from);
}

}  // namespace insonate::train
