#include "ImageInput.h"

#include "../model/ImagingModel.h"
#include "../model/NeedleMotion.h"
#include "../model/ProbeMotion.h"

#include <insonate/ui/CanvasInput.h>

#include <QDateTime>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>

namespace insonate::train {
namespace {

constexpr double kNotch = 120;  // in eighths of a degree, as Qt counts
constexpr double kWheelPress_mm = 0.5, kWheelDepth_mm = 5;
constexpr qint64 kOneTurnOfWheel_ms = 600;  // notches closer than this are undone together

}  // namespace

ImageInput::ImageInput(ImagingModel& imaging, ProbeMotion& motion, NeedleMotion& needle, views::UltrasoundView& view,
                       QWidget& canvas, QObject* parent)
    : QObject(parent), imaging_(imaging), motion_(motion), needle_(needle), view_(view), canvas_(canvas) {
  ui::CanvasInput::of(canvas).add(ui::InputRank::Pointer, *this);
}

bool ImageInput::eventFilter(QObject* watched, QEvent* event) {
  if (watched != &canvas_) return false;
  switch (event->type()) {
    case QEvent::MouseButtonPress:
      canvas_.setFocus(Qt::MouseFocusReason);
      return pressed(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseMove:
      return moved(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseButtonRelease:
      return released(*static_cast<QMouseEvent*>(event));
    // The second press of a double click is a press, where clicks measure.
    case QEvent::MouseButtonDblClick:
      return calipers_.kind() && pressed(*static_cast<QMouseEvent*>(event));
    case QEvent::Wheel:
      return wheel(*static_cast<QWheelEvent*>(event));
    default:
      return false;
  }
}

views::ImagePoint ImageInput::pictureAt(const QMouseEvent& event) const {
  const double ratio = canvas_.devicePixelRatioF();
  return view_.imageFromDisplay({(event.localPos().x() + 0.5) * ratio, (event.localPos().y() + 0.5) * ratio});
}

bool ImageInput::measuring(const QMouseEvent& event) const {
  return calipers_.kind() && (event.button() == Qt::LeftButton || event.button() == Qt::NoButton);
}

bool ImageInput::pressed(const QMouseEvent& event) {
  if (measuring(event)) {
    calipers_.pressed(pictureAt(event));
    measured_();
    return true;
  }
  if (held_ != Qt::NoButton) return true;
  held_ = event.button();
  last_ = event.localPos();
  motion_.beginGesture();
  return true;
}

bool ImageInput::moved(const QMouseEvent& event) {
  if (calipers_.placing()) {
    calipers_.moved(pictureAt(event));
    measured_();
    return true;
  }
  if (held_ == Qt::NoButton) return true;
  const QPointF by = event.localPos() - last_;
  last_ = event.localPos();
  const double mmPerPx = canvas_.devicePixelRatioF() / std::max(0.1, view_.px_per_mm());
  const bool shift = event.modifiers() & Qt::ShiftModifier;
  if (held_ == Qt::LeftButton) {
    motion_.slide(by.x() * mmPerPx, by.y() * mmPerPx);
  } else if (held_ == Qt::RightButton && shift) {
    if (by.x() != 0) motion_.move(HandAxis::Rock, by.x() * ProbeMotion::kDrag_degPerPx);
    if (by.y() != 0) motion_.move(HandAxis::Tilt, -by.y() * ProbeMotion::kDrag_degPerPx);
  } else if (held_ == Qt::RightButton && by.x() != 0) {
    motion_.move(HandAxis::Rotation, by.x() * ProbeMotion::kDrag_degPerPx);
  }
  return true;
}

bool ImageInput::released(const QMouseEvent& event) {
  if (measuring(event)) {
    calipers_.released(pictureAt(event));
    measured_();
    return true;
  }
  if (event.button() == held_) held_ = Qt::NoButton;
  return true;
}

bool ImageInput::wheel(const QWheelEvent& event) {
  const QPoint turned = event.angleDelta();
  const double notches = (turned.y() != 0 ? turned.y() : turned.x()) / kNotch;
  if (notches == 0) return true;
  if (event.modifiers() & Qt::ShiftModifier) {
    needle_.move(NeedleAxis::Advance, -notches * NeedleMotion::kWheel_mm);
    return true;
  }
  if (event.modifiers() & Qt::ControlModifier) {
    // Away from the user comes nearer, as in maps.
    ImagingSettings settings = imaging_.settings();
    settings.depth_mm -= notches * kWheelDepth_mm;
    imaging_.setSettings(settings);
    return true;
  }
  const qint64 now = QDateTime::currentMSecsSinceEpoch();
  if (now - lastWheel_ms_ > kOneTurnOfWheel_ms) motion_.beginGesture();
  lastWheel_ms_ = now;
  motion_.move(HandAxis::Press, notches * kWheelPress_mm);
  return true;
}

}  // namespace insonate::train
