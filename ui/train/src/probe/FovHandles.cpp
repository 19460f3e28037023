#include "FovHandles.h"

#include "../model/History.h"
#include "../model/ImagingModel.h"
#include "../model/StatusLine.h"

#include <insonate/ui/CanvasInput.h>
#include <insonate/ui/ViewKeys.h>

#include <QKeyEvent>
#include <QMouseEvent>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace insonate::train {
namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180;
constexpr double kHandleReach_px = 14;  // logical pixels round a handle
constexpr double kRoom = 0.12;          // of the field of view, for dragging outward
constexpr double kWide = 5;             // Shift
constexpr int kParts = 48;

bool isFan(const Probe& probe) {
  return probe.shape != ProbeShape::Linear;
}

/// A point of the field of view: across -1..1, at a range from the face.
views::ImagePoint pointAt(const Probe& probe, double across, double range_mm) {
  if (!isFan(probe)) return {across * probe.width_mm / 2, range_mm};
  const double angle = across * probe.fovAngle_deg / 2 * kRadiansPerDegree, reach = probe.faceRadius_mm + range_mm;
  return {reach * std::sin(angle), reach * std::cos(angle) - probe.faceRadius_mm};
}

void setWithin(Probe& probe, double Probe::*member, double value, double low = -1e9) {
  const ProbeField& field = *std::ranges::find(probeFields(), member, &ProbeField::member);
  probe.*member = std::clamp(std::round(value * 10) / 10, std::max(low, field.low), field.high);
}

std::string number(double value, const char* unit) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f%s", value, unit);
  return text;
}

}  // namespace

FovHandles::FovHandles(StatusLine& status, History& history, ImagingModel& imaging, views::UltrasoundView& view,
                       QWidget& canvas, QObject* parent)
    : QObject(parent), status_(status), history_(history), imaging_(imaging), view_(view), canvas_(canvas) {
  ui::CanvasInput::of(canvas).add(ui::InputRank::Handle, *this);
  connect(&imaging_, &ImagingModel::setupChanged, this, &FovHandles::refresh);
}

void FovHandles::setActive(bool active) {
  active_ = active;
  held_ = false;
  chosen_ = Handle::None;
  if (!active) {
    view_.setGuide({});
    canvas_.unsetCursor();
  }
  refresh();
}

views::ImageBounds FovHandles::roomFor(const views::ImageBounds& fov) const {
  if (!active_) return fov;
  const double wide = kRoom * (fov.maxLateral_mm - fov.minLateral_mm),
               deep = kRoom * (fov.maxAxial_mm - fov.minAxial_mm);
  return {fov.minLateral_mm - wide, fov.maxLateral_mm + wide, fov.minAxial_mm, fov.maxAxial_mm + deep};
}

views::ImagePoint FovHandles::placeOf(Handle handle) const {
  const Probe& probe = imaging_.probe();
  const double depth = imaging_.settings().depth_mm;
  switch (handle) {
    case Handle::RightSide:
      return pointAt(probe, 1, depth / 2);
    case Handle::LeftSide:
      return pointAt(probe, -1, depth / 2);
    case Handle::Face:
      return pointAt(probe, 1, 0);
    default:
      return pointAt(probe, 0, depth);
  }
}

views::DisplayPoint FovHandles::displayOf(Handle handle) const {
  return view_.displayFromImage(placeOf(handle));
}

void FovHandles::refresh() {
  if (!active_) return;
  const Probe& probe = imaging_.probe();
  const double depth = imaging_.settings().depth_mm;
  views::ShapeOverlay guide;
  for (int k = 0; k <= kParts; ++k) guide.outline.push_back(pointAt(probe, 2.0 * k / kParts - 1, 0));
  for (int k = kParts; k >= 0; --k) guide.outline.push_back(pointAt(probe, 2.0 * k / kParts - 1, depth));
  for (const Handle handle : {Handle::RightSide, Handle::LeftSide, Handle::Face, Handle::Depth}) {
    // A straight face has no radius.
    if (handle == Handle::Face && !isFan(probe)) {
      guide.handles.push_back(placeOf(Handle::Depth));
      guide.words.emplace_back();
      continue;
    }
    guide.handles.push_back(placeOf(handle));
    guide.words.push_back(handle == Handle::LeftSide    ? std::string()
                          : handle == Handle::RightSide ? isFan(probe) ? "alpha " + number(probe.fovAngle_deg, "\u00b0")
                                                                       : "width " + number(probe.width_mm, " mm")
                          : handle == Handle::Face ? "r1 " + number(probe.faceRadius_mm, " mm")
                          : isFan(probe)                ? "r2 " + number(probe.faceRadius_mm + depth, " mm")
                                                        : "depth " + number(depth, " mm"));
  }
  guide.chosen = int(chosen_);
  view_.setGuide(std::move(guide));
}

views::DisplayPoint FovHandles::pointOf(const QMouseEvent& event) const {
  const double ratio = canvas_.devicePixelRatioF();
  return {(event.localPos().x() + 0.5) * ratio, (event.localPos().y() + 0.5) * ratio};
}

FovHandles::Handle FovHandles::nearest(const QMouseEvent& event) const {
  const views::DisplayPoint at = pointOf(event);
  Handle best = Handle::None;
  double least = kHandleReach_px * canvas_.devicePixelRatioF();
  for (const Handle handle : {Handle::RightSide, Handle::LeftSide, Handle::Face, Handle::Depth}) {
    if (handle == Handle::Face && !isFan(imaging_.probe())) continue;
    const views::DisplayPoint place = displayOf(handle);
    const double far = std::hypot(place.x - at.x, place.y - at.y);
    if (far < least) least = far, best = handle;
  }
  return best;
}

void FovHandles::drag(views::ImagePoint to) {
  Probe probe = imaging_.probe();
  switch (chosen_) {
    case Handle::RightSide:
    case Handle::LeftSide: {
      const double across = chosen_ == Handle::RightSide ? to.lateral_mm : -to.lateral_mm;
      if (isFan(probe))
        setWithin(probe, &Probe::fovAngle_deg,
                  2 * std::atan2(across, to.axial_mm + probe.faceRadius_mm) / kRadiansPerDegree);
      else
        setWithin(probe, &Probe::width_mm, 2 * across);
      break;
    }
    case Handle::Face:
      // The corner stays under the mouse: it lies r1 sin(alpha / 2) beside the axis.
      setWithin(probe, &Probe::faceRadius_mm, to.lateral_mm / std::sin(probe.fovAngle_deg / 2 * kRadiansPerDegree),
                probe.shape == ProbeShape::Curvilinear ? 5 : 0);
      break;
    default:
      probe.defaultDepth_mm = std::clamp(std::round(to.axial_mm * 10) / 10, probe.minDepth_mm, probe.maxDepth_mm);
  }
  if (auto used = imaging_.useProbe(probe, "handle " + std::to_string(int(chosen_))); !used)
    status_.showMessage(QString::fromStdString(used.error().message));
}

void FovHandles::step(double amount) {
  Probe probe = imaging_.probe();
  switch (chosen_) {
    case Handle::None:
      return;
    case Handle::RightSide:
    case Handle::LeftSide:
      if (isFan(probe))
        setWithin(probe, &Probe::fovAngle_deg, probe.fovAngle_deg + amount);
      else
        setWithin(probe, &Probe::width_mm, probe.width_mm + amount);
      break;
    case Handle::Face:
      setWithin(probe, &Probe::faceRadius_mm, probe.faceRadius_mm + amount,
                probe.shape == ProbeShape::Curvilinear ? 5 : 0);
      break;
    case Handle::Depth:
      probe.defaultDepth_mm = std::clamp(imaging_.settings().depth_mm + amount, probe.minDepth_mm, probe.maxDepth_mm);
  }
  if (auto used = imaging_.useProbe(probe, "handle " + std::to_string(int(chosen_))); !used)
    status_.showMessage(QString::fromStdString(used.error().message));
}

bool FovHandles::key(const QKeyEvent& event, bool act) {
  const bool control = event.modifiers() & Qt::ControlModifier;
  if (event.key() == Qt::Key_G && !control) {
    if (!act) return true;
    do chosen_ = Handle((int(chosen_) + 1) % 4);
    while (chosen_ == Handle::Face && !isFan(imaging_.probe()));
    refresh();
    return true;
  }
  if (!control || chosen_ == Handle::None) return false;
  const bool more = event.key() == Qt::Key_Right || event.key() == Qt::Key_Down;
  if (!more && event.key() != Qt::Key_Left && event.key() != Qt::Key_Up) return false;
  if (act) step((more ? 1 : -1) * (event.modifiers() & Qt::ShiftModifier ? kWide : 1));
  return true;
}

bool FovHandles::eventFilter(QObject* watched, QEvent* event) {
  if (!active_ || watched != &canvas_) return false;
  switch (event->type()) {
    case QEvent::MouseButtonPress: {
      const auto& mouse = *static_cast<QMouseEvent*>(event);
      const Handle handle = mouse.button() == Qt::LeftButton ? nearest(mouse) : Handle::None;
      if (handle == Handle::None) return false;
      canvas_.setFocus(Qt::MouseFocusReason);
      chosen_ = handle, held_ = true;
      history_.close();
      refresh();
      return true;
    }
    case QEvent::MouseMove: {
      const auto& mouse = *static_cast<QMouseEvent*>(event);
      if (held_)
        drag(view_.imageFromDisplay(pointOf(mouse)));
      else if (mouse.buttons() == Qt::NoButton)
        canvas_.setCursor(nearest(mouse) == Handle::None ? Qt::ArrowCursor : Qt::SizeAllCursor);
      return held_;
    }
    case QEvent::MouseButtonRelease:
      if (!held_) return false;
      held_ = false;
      Q_EMIT released();
      return true;
    default:
      return ui::handleViewKey(*event, [this](const QKeyEvent& pressed, bool act) { return key(pressed, act); });
  }
}

}  // namespace insonate::train
