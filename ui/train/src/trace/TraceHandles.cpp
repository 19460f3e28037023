#include "TraceHandles.h"

#include "../layout/CanvasGeometry.h"
#include "../model/ImagingModel.h"
#include "TraceModel.h"

#include <insonate/ui/CanvasInput.h>
#include <insonate/ultrasound/BeamGrid.h>

#include <QMouseEvent>
#include <QWidget>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace insonate::train {
namespace {

constexpr double kGateReach_px = 12, kTraceLineReach_px = 6;
constexpr double kFlowArm_mm = 5, kTick_mm = 1.2;
constexpr double kDegreesPerRadian = 180 / std::numbers::pi;

/// Ends of a scanline at the face and at the depth of the image.
std::pair<Vec3, Vec3> endsOfLine(const ImagingModel& imaging, double across, double steering_deg) {
  ImagingSettings beams = imaging.settings();
  beams.steering_deg = steering_deg;
  const BeamGrid grid(imaging.probe(), beams);
  const double scanline = across * grid.scanlines() - 0.5;
  const Vec3 face = grid.origin(scanline);
  return {face, face + grid.direction(scanline) * grid.range_mm(grid.samples() - 0.5)};
}

views::ImagePoint shownAt(Vec3 point_mm) {
  return {point_mm.x, point_mm.z};
}

}  // namespace

TraceHandles::TraceHandles(ImagingModel& imaging, TraceModel& trace, views::UltrasoundView& view, QWidget& canvas,
                           QObject* parent)
    : QObject(parent), imaging_(imaging), trace_(trace), view_(view), canvas_(canvas) {
  ui::CanvasInput::of(canvas).add(ui::InputRank::Handle, *this);
  connect(&trace_, &TraceModel::changed, this, [this] { draw(); });
}

Vec3 TraceHandles::flowArm_mm() const {
  const Vec3 beam = trace_.place().beam;
  const double angle = trace_.angle_deg() / kDegreesPerRadian, c = std::cos(angle), s = std::sin(angle);
  return Vec3{c * beam.x + s * beam.z, 0, c * beam.z - s * beam.x} * kFlowArm_mm;
}

void TraceHandles::draw() {
  std::vector<views::LineOverlay> lines;
  const auto add = [&](Vec3 from, Vec3 to, bool isFine) { lines.push_back({shownAt(from), shownAt(to), isFine}); };
  if (trace_.isPwOn()) {
    const SpectralSettings gate = trace_.gate();
    const GatePlace place = trace_.place();
    const auto [face, end] = endsOfLine(imaging_, gate.across, gate.steering_deg);
    const Vec3 side{place.beam.z, 0, -place.beam.x};
    add(face, place.near_mm, true);
    add(place.far_mm, end, true);
    add(place.near_mm - side * kTick_mm, place.near_mm + side * kTick_mm, false);
    add(place.far_mm - side * kTick_mm, place.far_mm + side * kTick_mm, false);
    add(place.middle_mm - flowArm_mm(), place.middle_mm + flowArm_mm(), true);
  }
  if (trace_.isMModeOn()) {
    const auto [face, end] = endsOfLine(imaging_, trace_.line(), imaging_.settings().steering_deg);
    add(face, end, true);
  }
  view_.setLines(std::move(lines));
}

bool TraceHandles::eventFilter(QObject* watched, QEvent* event) {
  if (watched != &canvas_ || !(trace_.isPwOn() || trace_.isMModeOn() || held_)) return false;
  if (event->type() != QEvent::MouseButtonPress && event->type() != QEvent::MouseMove &&
      event->type() != QEvent::MouseButtonRelease)
    return false;
  const auto& mouse = *static_cast<QMouseEvent*>(event);
  if (event->type() == QEvent::MouseButtonPress) {
    if (mouse.button() != Qt::LeftButton || mouse.modifiers() != Qt::NoModifier) return false;
    held_ = partAt(pixelOf(mouse));
    return held_.has_value();
  }
  if (!held_) return false;
  drag(pixelOf(mouse));
  if (event->type() == QEvent::MouseButtonRelease && mouse.button() == Qt::LeftButton) held_.reset();
  return true;
}

QPointF TraceHandles::pixelOf(const QMouseEvent& event) const {
  return (event.localPos() + QPointF(0.5, 0.5)) * canvas_.devicePixelRatioF();
}

QPointF TraceHandles::onDisplay(Vec3 point_mm) const {
  const views::DisplayPoint at = view_.displayFromImage(shownAt(point_mm));
  return {at.x, at.y};
}

std::optional<TraceHandles::Part> TraceHandles::partAt(QPointF at_px) const {
  if (trace_.isPwOn()) {
    const GatePlace place = trace_.place();
    for (const Vec3 end : {place.middle_mm + flowArm_mm(), place.middle_mm - flowArm_mm()})
      if (distanceToSegment(at_px, onDisplay(end), onDisplay(end)) <= kGateReach_px) return Part::Flow;
    if (distanceToSegment(at_px, onDisplay(place.near_mm), onDisplay(place.far_mm)) <= kGateReach_px) return Part::Gate;
    const SpectralSettings gate = trace_.gate();
    const auto [face, end] = endsOfLine(imaging_, gate.across, gate.steering_deg);
    if (distanceToSegment(at_px, onDisplay(face), onDisplay(end)) <= kTraceLineReach_px) return Part::Line;
  }
  if (!trace_.isMModeOn()) return std::nullopt;
  const auto [face, end] = endsOfLine(imaging_, trace_.line(), imaging_.settings().steering_deg);
  if (distanceToSegment(at_px, onDisplay(face), onDisplay(end)) <= kTraceLineReach_px) return Part::MMode;
  return std::nullopt;
}

void TraceHandles::drag(QPointF to_px) {
  const views::ImagePoint to = view_.imageFromDisplay({to_px.x(), to_px.y()});
  if (*held_ == Part::Flow) {
    const GatePlace place = trace_.place();
    const Vec3 way = Vec3{to.lateral_mm, 0, to.axial_mm} - place.middle_mm;
    // The line has two ends; the one deeper along the beam gives the angle.
    const double along = dot(way, place.beam), side = dot(way, Vec3{place.beam.z, 0, -place.beam.x});
    return trace_.setAngle(std::atan2(along < 0 ? -side : side, std::abs(along)) * kDegreesPerRadian);
  }
  const bool isGate = *held_ != Part::MMode;
  SpectralSettings gate = trace_.gate();
  ImagingSettings beams = imaging_.settings();
  if (isGate) beams.steering_deg = gate.steering_deg;
  const BeamGrid grid(imaging_.probe(), beams);
  const BeamGrid::Location place = grid.locate(to.lateral_mm, to.axial_mm);
  const double across = (place.scanline + 0.5) / grid.scanlines();
  if (!isGate) return trace_.setLine(across);
  gate.across = across;
  if (*held_ == Part::Gate) gate.range_mm = grid.range_mm(place.sample);
  trace_.setGate(gate);
}

}  // namespace insonate::train
