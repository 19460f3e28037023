#include "PatientBox.h"
#include "SceneDrawing.h"
#include "ScenePick.h"

#include <vtkMatrix4x4.h>

#include <algorithm>
#include <cmath>

namespace insonate::views {

void SceneView::setViewpoint(Viewpoint from) {
  drawing_->viewpoint = from;
  drawing_->framed = false;
  changed();
}

void SceneView::frame() {
  double box[6];
  if (drawing_->framed || !patientBox(drawing_->state, drawing_->patient.get(), box)) return;
  lookAt(*drawing_->usual, drawing_->viewpoint, box, double(width_px()) / height_px());
  drawing_->framed = true;
}

void SceneView::orbit(double across_deg, double up_deg) {
  frame();
  vtkCamera& camera = *drawing_->usual;
  camera.Azimuth(-across_deg);
  camera.Elevation(up_deg);
  camera.OrthogonalizeViewUp();
  changed();
}

void SceneView::pan(double across_px, double down_px) {
  frame();
  vtkCamera& camera = *drawing_->usual;
  const double* forward = camera.GetDirectionOfProjection();
  const double* upward = camera.GetViewUp();
  const Vec3 into{forward[0], forward[1], forward[2]}, up{upward[0], upward[1], upward[2]};
  const double mm_per_px = 2 * camera.GetDistance() * std::tan(camera.GetViewAngle() * 3.14159265 / 360) / height_px();
  const Vec3 shift = (up * down_px - normalized(cross(into, up)) * across_px) * mm_per_px;
  const double *at = camera.GetPosition(), *focus = camera.GetFocalPoint();
  camera.SetFocalPoint(focus[0] + shift.x, focus[1] + shift.y, focus[2] + shift.z);
  camera.SetPosition(at[0] + shift.x, at[1] + shift.y, at[2] + shift.z);
  changed();
}

void SceneView::zoom(double factor) {
  frame();
  drawing_->usual->Dolly(std::clamp(factor, 0.1, 10.0));
  changed();
}

DisplayPoint SceneView::displayFromPatient(Vec3 point_mm) {
  const double at[4] = {point_mm.x, point_mm.y, point_mm.z, 1};
  double seen[4];
  aimed().GetCompositeProjectionTransformMatrix(double(width_px()) / height_px(), -1, 1)->MultiplyPoint(at, seen);
  return {(seen[0] / seen[3] + 1) / 2 * width_px(), (1 - seen[1] / seen[3]) / 2 * height_px()};
}

Vec3 SceneView::along(DisplayPoint at, double depth) {
  vtkNew<vtkMatrix4x4> patientFromSeen;
  vtkMatrix4x4::Invert(aimed().GetCompositeProjectionTransformMatrix(double(width_px()) / height_px(), -1, 1),
                       patientFromSeen);
  const double seen[4] = {2 * at.x / width_px() - 1, 1 - 2 * at.y / height_px(), depth, 1};
  double point[4];
  patientFromSeen->MultiplyPoint(seen, point);
  return Vec3{point[0], point[1], point[2]} / point[3];
}

std::optional<ScenePick> SceneView::pick(DisplayPoint at, double minOpacity) {
  if (!drawing_->patient) return std::nullopt;
  std::array<bool, 256> visible{};
  for (std::size_t label = 1; label < 256; ++label) {
    const auto& look = drawing_->state.looks[label];
    visible[label] = look.visible && look.opacity > 0 && look.opacity >= minOpacity;
  }
  return firstVisible(drawing_->patient->labels(), along(at, -1), along(at, 1), visible, drawing_->state.cut);
}

Vec3 SceneView::pointInFrontOf(DisplayPoint at) {
  // As near as possible without clipping by the near plane.
  constexpr double kBehindNear = 0.02;
  const Vec3 near_mm = along(at, -1);
  return near_mm + (along(at, 1) - near_mm) * kBehindNear;
}

Vec3 SceneView::eye_mm() {
  const double* at = aimed().GetPosition();
  return {at[0], at[1], at[2]};
}

bool SceneView::pressed(const Pointer& pointer) {
  if (pointer.button == Button::None) return false;
  drawing_->held = pointer.button;
  drawing_->last = pointer.at;
  setMoving(true);
  return true;
}

bool SceneView::moved(const Pointer& pointer) {
  if (drawing_->held == Button::None) return false;
  const double across = pointer.at.x - drawing_->last.x, down = pointer.at.y - drawing_->last.y;
  drawing_->last = pointer.at;
  if (drawing_->held == Button::Right) {
    zoom(std::exp(-down / (200 * scale())));
  } else if (drawing_->held == Button::Middle || pointer.shift) {
    pan(across, down);
  } else {
    // The height of the view is half a rotation.
    orbit(180 * across / height_px(), 180 * down / height_px());
  }
  return true;
}

bool SceneView::released(const Pointer&) {
  if (drawing_->held == Button::None) return false;
  drawing_->held = Button::None;
  setMoving(false);
  return true;
}

bool SceneView::wheel(const Pointer&, double notches) {
  setMoving(true);
  zoom(std::pow(1.12, notches));
  return true;
}

void SceneView::inputIdle() {
  if (drawing_->held == Button::None) setMoving(false);
}

bool SceneView::key(Key key) {
  if (key != Key::R) return false;
  setViewpoint(Viewpoint::Anterior);
  return true;
}

}  // namespace insonate::views
