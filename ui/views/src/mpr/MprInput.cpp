#include "MprDrawing.h"

#include <algorithm>
#include <cmath>

namespace insonate::views {

void MprView::moveCrosshair(Vec3 position_mm) {
  if (position_mm == crosshair_mm_) return;
  setCrosshair(position_mm);
  if (crosshairMoved_) crosshairMoved_(position_mm);
}

bool MprView::pressed(const Pointer& pointer) {
  if (!patient_ || pointer.button == Button::None) return false;
  held_ = pointer.button;
  last_ = pointer.at;
  if (held_ == Button::Left) moveCrosshair(patientFromDisplay(pointer.at));
  return true;
}

bool MprView::moved(const Pointer& pointer) {
  if (!patient_) return false;
  const double across = pointer.at.x - last_.x, along = pointer.at.y - last_.y;
  last_ = pointer.at;
  const bool points = held_ == Button::Left || (held_ == Button::None && pointer.shift);
  if (points) {
    moveCrosshair(patientFromDisplay(pointer.at));
  } else if (held_ == Button::Middle && asPicture()) {
    return true;
  } else if (held_ == Button::Middle) {
    stopFitting();
    const SliceAxes axes = plane().axes;
    middle_mm_ = middle_mm_ - axes.right * (across * mm_per_px_) + axes.up * (along * mm_per_px_);
    changed();
  } else if (held_ == Button::Right) {
    // Proportional to the window: a drag over the whole view changes it by about three windows.
    const double step_HU = std::max(0.5, windowLevel_.window_HU / 300) / scale();
    setWindowLevel({windowLevel_.window_HU + across * step_HU, windowLevel_.level_HU + along * step_HU});
    if (windowLevelChanged_) windowLevelChanged_(windowLevel_);
  } else {
    return false;
  }
  return true;
}

bool MprView::released(const Pointer&) {
  const bool used = held_ != Button::None;
  held_ = Button::None;
  return used;
}

bool MprView::wheel(const Pointer& pointer, double notches) {
  if (!patient_) return false;
  if (asPicture()) return true;
  if (pointer.control || kind_ == SliceKind::Oblique) {
    // The point under the pointer does not move.
    const Vec3 before_mm = patientFromDisplay(pointer.at);
    zoom(std::pow(1.15, notches));
    middle_mm_ = middle_mm_ + (before_mm - patientFromDisplay(pointer.at));
    changed();
    return true;
  }
  wheelRest_ += notches;
  const int whole = static_cast<int>(std::trunc(wheelRest_));
  wheelRest_ -= whole;
  if (whole != 0) stepSlices(whole);
  return true;
}

bool MprView::key(Key key) {
  switch (key) {
    case Key::Up:
    case Key::Right:
      stepSlices(1);
      return true;
    case Key::Down:
    case Key::Left:
      stepSlices(-1);
      return true;
    case Key::PageUp:
      stepSlices(10);
      return true;
    case Key::PageDown:
      stepSlices(-10);
      return true;
    case Key::G:
      setLabelsVisible(!labelsVisible_);
      return true;
    case Key::A:
      setLabelOpacity(labelOpacity_ - 0.05);
      return true;
    case Key::D:
      setLabelOpacity(labelOpacity_ + 0.05);
      return true;
    case Key::R:
      fit();
      return true;
  }
  return false;
}

}  // namespace insonate::views
