#include "Canvas.h"

#include <QFocusEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QTimerEvent>
#include <QWheelEvent>
#include <cmath>
#include <optional>

namespace insonate::ui {
namespace {

/// After this long without a wheel, a view is drawn exactly again.
constexpr int kRest_ms = 300;
constexpr double kDegreesOfANotch = 120;  // in eighths, as Qt counts

views::Button viewButton(Qt::MouseButton button) {
  switch (button) {
    case Qt::LeftButton:
      return views::Button::Left;
    case Qt::MiddleButton:
      return views::Button::Middle;
    case Qt::RightButton:
      return views::Button::Right;
    default:
      return views::Button::None;
  }
}

std::optional<views::Key> viewKey(int key) {
  switch (key) {
    case Qt::Key_Up:
      return views::Key::Up;
    case Qt::Key_Down:
      return views::Key::Down;
    case Qt::Key_Left:
      return views::Key::Left;
    case Qt::Key_Right:
      return views::Key::Right;
    case Qt::Key_PageUp:
      return views::Key::PageUp;
    case Qt::Key_PageDown:
      return views::Key::PageDown;
    case Qt::Key_A:
      return views::Key::A;
    case Qt::Key_D:
      return views::Key::D;
    case Qt::Key_G:
      return views::Key::G;
    case Qt::Key_R:
      return views::Key::R;
    default:
      return std::nullopt;
  }
}

}  // namespace

ViewWidget::Canvas::Canvas(views::View& view, QWidget* parent) : QWidget(parent), view_(view) {
  window_->SetOffScreenRendering(true);
  window_->SetShowWindow(false);
  window_->SetMultiSamples(0);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setMinimumSize(64, 64);
}

ViewWidget::Canvas::~Canvas() = default;

QSize ViewWidget::Canvas::deviceSize() const {
  const double ratio = devicePixelRatioF();
  return {int(std::lround(width() * ratio)), int(std::lround(height() * ratio))};
}

void ViewWidget::Canvas::render() {
  const QSize size = deviceSize();
  if (size != picture_.size()) {
    window_->SetSize(size.width(), size.height());
    view_.resize(size.width(), size.height(), devicePixelRatioF());
    picture_ = QImage(size, QImage::Format_RGB32);
  }
  picture_.setDevicePixelRatio(devicePixelRatioF());
  view_.render();
  takePixels();
  update();
}

void ViewWidget::Canvas::forget() {
  picture_ = QImage();
  update();
}

/// OpenGL counts rows from below and has red first in memory.
void ViewWidget::Canvas::takePixels() {
  const int width = picture_.width(), height = picture_.height();
  window_->GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, pixels_);
  for (int y = 0; y < height; ++y) {
    const unsigned char* from = pixels_->GetPointer(vtkIdType(4) * width * (height - 1 - y));
    auto* to = reinterpret_cast<QRgb*>(picture_.scanLine(y));
    for (int x = 0; x < width; ++x, from += 4) to[x] = qRgb(from[0], from[1], from[2]);
  }
}

void ViewWidget::Canvas::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  // What a picture of another size leaves free would show whatever was there before.
  if (picture_.size() != deviceSize()) painter.fillRect(rect(), Qt::black);
  if (!picture_.isNull()) painter.drawImage(rect().topLeft(), picture_);
  if (picture_.size() != deviceSize() && onStale) onStale();
}

void ViewWidget::Canvas::resizeEvent(QResizeEvent*) {
  if (onStale) onStale();
}

views::DisplayPoint ViewWidget::Canvas::devicePoint(QPointF at) const {
  const double ratio = devicePixelRatioF();
  return {(at.x() + 0.5) * ratio, (at.y() + 0.5) * ratio};
}

views::Pointer ViewWidget::Canvas::pointer(const QMouseEvent& event, Qt::MouseButton button) const {
  return {devicePoint(event.localPos()), viewButton(button), event.modifiers().testFlag(Qt::ShiftModifier),
          event.modifiers().testFlag(Qt::ControlModifier)};
}

void ViewWidget::Canvas::mousePressEvent(QMouseEvent* event) {
  if (held_ != Qt::NoButton) return;
  held_ = event->button();
  view_.pressed(pointer(*event, held_));
}

void ViewWidget::Canvas::mouseMoveEvent(QMouseEvent* event) {
  view_.moved(pointer(*event, held_));
}

void ViewWidget::Canvas::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != held_) return;
  held_ = Qt::NoButton;
  view_.released(pointer(*event, event->button()));
}

void ViewWidget::Canvas::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && onDoubleClick && onDoubleClick()) return;
  mousePressEvent(event);
}

void ViewWidget::Canvas::wheelEvent(QWheelEvent* event) {
  // Alt turns a wheel into a sideways one.
  const QPoint turned = event->angleDelta();
  const double notches = (turned.y() != 0 ? turned.y() : turned.x()) / kDegreesOfANotch;
  const views::Pointer at{devicePoint(event->position()), viewButton(held_),
                          event->modifiers().testFlag(Qt::ShiftModifier),
                          event->modifiers().testFlag(Qt::ControlModifier)};
  event->setAccepted(notches != 0 && view_.wheel(at, notches));
  rest_.start(kRest_ms, this);
}

void ViewWidget::Canvas::timerEvent(QTimerEvent* event) {
  if (event->timerId() != rest_.timerId()) return QWidget::timerEvent(event);
  rest_.stop();
  view_.rested();
}

void ViewWidget::Canvas::keyPressEvent(QKeyEvent* event) {
  const auto key = viewKey(event->key());
  const bool plain = !(event->modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
  if (key && plain && view_.key(*key)) return rest_.start(kRest_ms, this);
  event->ignore();
}

void ViewWidget::Canvas::focusInEvent(QFocusEvent* event) {
  QWidget::focusInEvent(event);
  if (onFocus) onFocus(true);
}

void ViewWidget::Canvas::focusOutEvent(QFocusEvent* event) {
  QWidget::focusOutEvent(event);
  if (onFocus) onFocus(false);
}

}  // namespace insonate::ui
