#include "Canvas.h"

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>

#include <QFocusEvent>
#include <QKeyEvent>
#include <QMouseEvent>
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

ViewWidget::Canvas::Canvas(views::View& view, QWidget* parent) : QVTKOpenGLNativeWidget(parent), view_(view) {
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  window->SetMultiSamples(0);
  setRenderWindow(window);
  window->SetInteractor(nullptr);
  // Views scale their text themselves; VTK's widget would do it once more.
  setEnableHiDPI(false);
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setMinimumSize(64, 64);
}

bool ViewWidget::Canvas::event(QEvent* event) {
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseMove:
    case QEvent::Wheel:
    case QEvent::KeyPress:
    case QEvent::KeyRelease:
    case QEvent::Enter:
    case QEvent::Leave:
      return QOpenGLWidget::event(event);
    default:
      return QVTKOpenGLNativeWidget::event(event);
  }
}

void ViewWidget::Canvas::resizeGL(int width, int height) {
  QVTKOpenGLNativeWidget::resizeGL(width, height);
  const double ratio = devicePixelRatioF();
  view_.resize(int(std::lround(this->width() * ratio)), int(std::lround(this->height() * ratio)), ratio);
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
  if (event->timerId() != rest_.timerId()) return QVTKOpenGLNativeWidget::timerEvent(event);
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
  QVTKOpenGLNativeWidget::focusInEvent(event);
  if (onFocus) onFocus(true);
}

void ViewWidget::Canvas::focusOutEvent(QFocusEvent* event) {
  QVTKOpenGLNativeWidget::focusOutEvent(event);
  if (onFocus) onFocus(false);
}

}  // namespace insonate::ui
