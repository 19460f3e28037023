#include "SceneInput.h"

#include "../model/HapticControl.h"
#include "../model/NeedleMotion.h"
#include "../model/ProbeMotion.h"

#include <insonate/ui/CanvasInput.h>

#include <QApplication>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>

namespace insonate::train {

SceneInput::SceneInput(HapticControl& hands, ProbeMotion& motion, NeedleMotion& needle, views::SceneView& view,
                       QWidget& canvas, QObject* parent)
    : QObject(parent), hands_(hands), motion_(motion), needle_(needle), view_(view), canvas_(canvas) {
  ui::CanvasInput::of(canvas).add(ui::InputRank::Pointer, *this);
}

bool SceneInput::eventFilter(QObject* watched, QEvent* event) {
  if (watched != &canvas_) return false;
  switch (event->type()) {
    case QEvent::MouseButtonPress:
      return pressed(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseMove:
      return moved(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseButtonRelease:
      return released(*static_cast<QMouseEvent*>(event));
    case QEvent::Wheel:
      return wheel(*static_cast<QWheelEvent*>(event));
    default:
      return false;
  }
}

views::Pointer SceneInput::pointer(const QMouseEvent& event) const {
  const double ratio = canvas_.devicePixelRatioF();
  // The middle button is the view's left one: it turns the camera wherever it is pressed.
  return {{(event.localPos().x() + 0.5) * ratio, (event.localPos().y() + 0.5) * ratio},
          views::Button::Left,
          event.modifiers().testFlag(Qt::ShiftModifier),
          event.modifiers().testFlag(Qt::ControlModifier)};
}

bool SceneInput::pressed(const QMouseEvent& event) {
  if (drag_ != Drag::None) return true;
  canvas_.setFocus(Qt::MouseFocusReason);
  from_ = last_ = event.localPos();
  begun_ = false;
  const bool left = event.button() == Qt::LeftButton, right = event.button() == Qt::RightButton;
  if (left && trayTaken_ && isOnTray(event)) {
    trayTaken_();
    return true;
  }
  const auto picked = left || right ? view_.pick(pointer(event).at) : std::nullopt;
  if (picked && left && motion_.isUnplaced()) {
    motion_.placeOnSkin();
    motion_.moveTo(picked->position_mm);
  }
  if (picked && left && event.modifiers().testFlag(Qt::ControlModifier)) {
    drag_ = Drag::Needle;
    return true;
  }
  if (picked && motion_.isReady()) {
    drag_ = left ? Drag::Slide : Drag::Rotate;
    motion_.beginGesture();
    return true;
  }
  if (right) return false;
  drag_ = Drag::Camera;
  view_.pressed(pointer(event));
  return true;
}

/// As it is seen: within the rectangle round its corners.
bool SceneInput::isOnTray(const QMouseEvent& event) {
  if (!tray_) return false;
  const Vec3 half = views::SceneView::kTray_mm * 0.5;
  const views::DisplayPoint at = pointer(event).at;
  views::DisplayPoint least{1e9, 1e9}, most{-1e9, -1e9};
  for (const double x : {-half.x, half.x})
    for (const double y : {-half.y, half.y}) {
      const views::DisplayPoint corner = view_.displayFromPatient(*tray_ * Vec3{x, y, 0});
      least = {std::min(least.x, corner.x), std::min(least.y, corner.y)};
      most = {std::max(most.x, corner.x), std::max(most.y, corner.y)};
    }
  return at.x > least.x && at.x < most.x && at.y > least.y && at.y < most.y;
}

bool SceneInput::moved(const QMouseEvent& event) {
  if (drag_ == Drag::None) return false;
  if (drag_ == Drag::Camera) {
    view_.moved(pointer(event));
    return true;
  }
  begun_ = begun_ || (event.localPos() - from_).manhattanLength() >= QApplication::startDragDistance();
  if (!begun_) return true;
  const QPointF by = event.localPos() - last_;
  last_ = event.localPos();
  if (drag_ == Drag::Rotate) {
    motion_.move(HandAxis::Rotation, by.x() * ProbeMotion::kDrag_degPerPx);
  } else if (drag_ == Drag::Needle) {
    if (const auto picked = view_.pick(pointer(event).at)) hands_.needleTo(picked->position_mm);
  } else if (const auto picked = view_.pick(pointer(event).at)) {
    motion_.moveTo(picked->position_mm);
  }
  return true;
}

bool SceneInput::wheel(const QWheelEvent& event) {
  if (!event.modifiers().testFlag(Qt::ShiftModifier)) return false;
  constexpr double kNotch = 120;  // in eighths of a degree, as Qt counts
  const QPoint turned = event.angleDelta();
  needle_.move(NeedleAxis::Advance, -(turned.y() != 0 ? turned.y() : turned.x()) / kNotch * NeedleMotion::kWheel_mm);
  return true;
}

bool SceneInput::released(const QMouseEvent& event) {
  if (drag_ == Drag::None) return false;
  if (drag_ == Drag::Camera) view_.released(pointer(event));
  drag_ = Drag::None;
  return true;
}

}  // namespace insonate::train
