#include "Canvas.h"

#include <insonate/ui/Theme.h>

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QFocusEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QTimerEvent>
#include <QWheelEvent>
#include <cmath>
#include <mutex>
#include <optional>
#include <utility>

namespace insonate::ui {
namespace {

/// Time without wheel input after which a view is drawn exactly again.
constexpr int kWheelRest_ms = 300;
constexpr double kDegreesOfANotch = 120;  // in eighths of a degree, as Qt counts

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
  setAttribute(Qt::WA_OpaquePaintEvent);
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setMinimumSize(64, 64);
  if (view_.canDrawOnThread()) {
    // Unread results are dropped with the canvas, which ends the thread first.
    thread_ = std::make_unique<views::DrawingThread>(
        view_, [this] { QCoreApplication::postEvent(this, new QEvent(QEvent::User)); });
    return;
  }
  window_ = vtkSmartPointer<vtkRenderWindow>::New();
  window_->SetOffScreenRendering(true);
  window_->SetShowWindow(false);
  window_->SetMultiSamples(0);
  view_.attach(window_);
}

ViewWidget::Canvas::~Canvas() {
  if (thread_) return;
  const auto alone = views::DrawingThread::pause();
  view_.detach();
  window_ = nullptr;
}

QSize ViewWidget::Canvas::deviceSize() const {
  const double ratio = devicePixelRatioF();
  return {int(std::lround(width() * ratio)), int(std::lround(height() * ratio))};
}

void ViewWidget::Canvas::fit() {
  const QSize size = deviceSize();
  if (isDrawing() || (size == fitted_ && devicePixelRatioF() == ratio_)) return;
  fitted_ = size, ratio_ = devicePixelRatioF();
  if (!thread_) window_->SetSize(size.width(), size.height());
  view_.resize(size.width(), size.height(), ratio_);
}

void ViewWidget::Canvas::render() {
  if (isDrawing()) return;
  if (thread_) {
    wish_ = thread_->requestFrame();
    return;
  }
  QElapsedTimer clock;
  clock.start();
  const auto alone = std::exchange(isOpen_, true) ? std::unique_lock<std::mutex>() : views::DrawingThread::pause();
  view_.render();
  reader_.read(*window_, drawn_.pixels);
  drawn_.took_ms = double(clock.nsecsElapsed()) / 1e6;
  show(drawn_.pixels);
}

bool ViewWidget::Canvas::event(QEvent* event) {
  if (event->type() != QEvent::User) return QWidget::event(event);
  takeDrawn();
  return true;
}

void ViewWidget::Canvas::takeDrawn() {
  // The memory of the shown image is reused for the next one.
  if (!thread_ || !thread_->takeFrame(drawn_)) return;
  if (drawn_.wish > forgotten_) return show(drawn_.pixels);
  picture_ = QImage();
  if (onDrawn) onDrawn(drawn_.took_ms);
}

void ViewWidget::Canvas::show(const views::Pixels& pixels) {
  picture_ = QImage(reinterpret_cast<const uchar*>(pixels.argb.data()), pixels.width, pixels.height,
                    int(sizeof(QRgb)) * pixels.width, QImage::Format_RGB32);
  picture_.setDevicePixelRatio(devicePixelRatioF());
  update();
  if (onDrawn) onDrawn(drawn_.took_ms);
}

void ViewWidget::Canvas::forget() {
  picture_ = QImage();
  forgotten_ = wish_;
  update();
}

void ViewWidget::Canvas::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  // An image of another size would leave old contents around it.
  if (picture_.size() != deviceSize()) painter.fillRect(rect(), toQColor(views::theme::kBlack));
  if (!picture_.isNull()) painter.drawImage(rect().topLeft(), picture_);
  askIfStale();
}

void ViewWidget::Canvas::resizeEvent(QResizeEvent*) {
  askIfStale();
}

void ViewWidget::Canvas::askIfStale() {
  const bool onItsWay = isDrawing() && fitted_ == deviceSize();
  if (picture_.size() != deviceSize() && !onItsWay && onStale) onStale();
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
  // Alt makes a wheel event horizontal.
  const QPoint turned = event->angleDelta();
  const double notches = (turned.y() != 0 ? turned.y() : turned.x()) / kDegreesOfANotch;
  const views::Pointer at{devicePoint(event->position()), viewButton(held_),
                          event->modifiers().testFlag(Qt::ShiftModifier),
                          event->modifiers().testFlag(Qt::ControlModifier)};
  event->setAccepted(notches != 0 && view_.wheel(at, notches));
  rest_.start(kWheelRest_ms, this);
}

void ViewWidget::Canvas::timerEvent(QTimerEvent* event) {
  if (event->timerId() != rest_.timerId()) return QWidget::timerEvent(event);
  rest_.stop();
  view_.inputIdle();
}

void ViewWidget::Canvas::keyPressEvent(QKeyEvent* event) {
  const auto key = viewKey(event->key());
  const bool plain = !(event->modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
  if (key && plain && view_.key(*key)) return rest_.start(kWheelRest_ms, this);
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
