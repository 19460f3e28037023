#include "SceneDrawing.h"

#include <vtkRenderWindow.h>

#include <cmath>

namespace insonate::views {
namespace {

/// The screen where the camera looks, square to it, as high as what the camera sees there.
Transform screenBefore(vtkCamera& camera, double height_mm) {
  const double *into = camera.GetDirectionOfProjection(), *upward = camera.GetViewUp(), *focus = camera.GetFocalPoint();
  const Vec3 toward = normalized(-Vec3{into[0], into[1], into[2]});
  const Vec3 right = normalized(cross({upward[0], upward[1], upward[2]}, toward));
  const double seen_mm = 2 * camera.GetDistance() * std::tan(camera.GetViewAngle() * 3.14159265 / 360);
  const double scale = seen_mm / height_mm;
  return {{{right * scale, cross(toward, right) * scale, toward * scale}}, {focus[0], focus[1], focus[2]}};
}

}  // namespace

void SceneView::setStereo(Stereo stereo) {
  drawing_->stereo = stereo;
  if (window()) useStereo(*window(), stereo);
  changed();
}

Stereo SceneView::stereo() const {
  return drawing_->stereo;
}

bool SceneView::supports(Stereo stereo) {
  return stereo != Stereo::QuadBuffer || (window() && window()->GetStereoCapableWindow());
}

void SceneView::setHeadCoupling(std::optional<HeadCoupling> coupling) {
  // An eye in or behind the screen sees nothing through it.
  if (coupling && !(coupling->eye_mm.z >= 1 && coupling->width_mm > 0 && coupling->height_mm >= 0)) coupling.reset();
  drawing_->coupling = coupling;
  changed();
}

const std::optional<HeadCoupling>& SceneView::headCoupling() const {
  return drawing_->coupling;
}

Vec3 SceneView::towardViewer() const {
  const double* into = drawing_->usual->GetDirectionOfProjection();
  return -Vec3{into[0], into[1], into[2]};
}

void SceneView::aim() {
  frame();
  if (!drawing_->coupling) {
    renderer()->SetActiveCamera(drawing_->usual);
    renderer()->ResetCameraClippingRange();
    return;
  }
  HeadCoupling coupling = *drawing_->coupling;
  if (coupling.height_mm == 0) coupling.height_mm = coupling.width_mm * height_px() / width_px();
  if (!coupling.patientFromScreen) coupling.patientFromScreen = screenBefore(*drawing_->usual, coupling.height_mm);
  vtkCamera& camera = *drawing_->coupled;
  const double half_mm = drawing_->stereo == Stereo::Off ? 0 : coupling.eyeSeparation_mm / 2;
  const double across_mm = camera.GetLeftEye() ? -half_mm : half_mm;
  standBeforeScreen(camera, coupling, across_mm);
  renderer()->SetActiveCamera(&camera);
  renderer()->ResetCameraClippingRange();
  lookThroughScreen(camera, coupling, across_mm);
}

}  // namespace insonate::views
