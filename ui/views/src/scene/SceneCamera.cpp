#include "SceneCamera.h"

#include <vtkCamera.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkRenderWindow.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace insonate::views {
namespace {

struct Direction {
  Vec3 toCamera, up;
};

Direction directionOf(Viewpoint from) {
  switch (from) {
    case Viewpoint::Posterior:
      return {{0, 1, 0}, {0, 0, 1}};
    case Viewpoint::Left:
      return {{1, 0, 0}, {0, 0, 1}};
    case Viewpoint::Right:
      return {{-1, 0, 0}, {0, 0, 1}};
    case Viewpoint::Superior:
      return {{0, 0, 1}, {0, -1, 0}};
    case Viewpoint::Inferior:
      return {{0, 0, -1}, {0, -1, 0}};
    case Viewpoint::Anterior:
      break;
  }
  return {{0, -1, 0}, {0, 0, 1}};
}

void set(void (vtkCamera::*setter)(double, double, double), vtkCamera& camera, Vec3 v) {
  (camera.*setter)(v.x, v.y, v.z);
}

}  // namespace

void lookAt(vtkCamera& camera, Viewpoint from, const double box[6], double widthOverHeight) {
  const Direction direction = directionOf(from);
  const Vec3 middle{0.5 * (box[0] + box[1]), 0.5 * (box[2] + box[3]), 0.5 * (box[4] + box[5])};
  const Vec3 half{0.5 * (box[1] - box[0]), 0.5 * (box[3] - box[2]), 0.5 * (box[5] - box[4])};
  const Vec3 right = cross(direction.up, direction.toCamera);
  const auto reach = [&](Vec3 axis) {
    return std::abs(axis.x) * half.x + std::abs(axis.y) * half.y + std::abs(axis.z) * half.z;
  };
  constexpr double kViewAngle_deg = 26, kMargin = 1.06;
  const double slope = std::tan(0.5 * vtkMath::RadiansFromDegrees(kViewAngle_deg));
  const double high = std::max(reach(direction.up), reach(right) / widthOverHeight);
  const double distance = reach(direction.toCamera) + kMargin * std::max(high, 1.0) / slope;
  camera.SetViewAngle(kViewAngle_deg);
  set(&vtkCamera::SetFocalPoint, camera, middle);
  set(&vtkCamera::SetPosition, camera, middle + direction.toCamera * distance);
  set(&vtkCamera::SetViewUp, camera, direction.up);
}

CameraPlace placeOf(vtkCamera& camera) {
  const auto vector = [](const double* v) { return Vec3{v[0], v[1], v[2]}; };
  return {vector(camera.GetPosition()), vector(camera.GetFocalPoint()), vector(camera.GetViewUp()),
          camera.GetViewAngle()};
}

void stand(vtkCamera& camera, const CameraPlace& place) {
  set(&vtkCamera::SetFocalPoint, camera, place.focus_mm);
  set(&vtkCamera::SetPosition, camera, place.position_mm);
  set(&vtkCamera::SetViewUp, camera, place.up);
  camera.SetViewAngle(place.angle_deg);
}

void enclose(vtkCamera& camera, const double box[6]) {
  const CameraPlace place = placeOf(camera);
  const Vec3 into = normalized(place.focus_mm - place.position_mm);
  double near_mm = std::numeric_limits<double>::max(), far_mm = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 at{box[corner & 1], box[2 + (corner >> 1 & 1)], box[4 + (corner >> 2 & 1)]};
    const double depth_mm = dot(at - place.position_mm, into);
    near_mm = std::min(near_mm, depth_mm), far_mm = std::max(far_mm, depth_mm);
  }
  constexpr double kNearest = 1e-3;  // relative to the farthest
  far_mm = std::max(far_mm, 1.0);
  camera.SetClippingRange(std::max(near_mm, kNearest * far_mm), far_mm);
}

namespace {

/// The screen at the focal point of the camera, perpendicular to its view, as high as the view there.
Transform screenBefore(vtkCamera& camera, double height_mm) {
  const CameraPlace place = placeOf(camera);
  const Vec3 toward = normalized(place.position_mm - place.focus_mm);
  const Vec3 right = normalized(cross(place.up, toward));
  const double seen_mm =
      2 * norm(place.position_mm - place.focus_mm) * std::tan(0.5 * vtkMath::RadiansFromDegrees(place.angle_deg));
  const double scale = seen_mm / height_mm;
  return {{{right * scale, cross(toward, right) * scale, toward * scale}}, place.focus_mm};
}

}  // namespace

HeadCoupling placed(HeadCoupling coupling, vtkCamera& usual, int width_px, int height_px) {
  if (coupling.height_mm == 0) coupling.height_mm = coupling.width_mm * height_px / width_px;
  if (!coupling.patientFromScreen) coupling.patientFromScreen = screenBefore(usual, coupling.height_mm);
  return coupling;
}

namespace {

Vec3 eyeOf(const HeadCoupling& coupling, double across_mm) {
  return coupling.eye_mm + Vec3{across_mm, 0, 0};
}

}  // namespace

void standBeforeScreen(vtkCamera& camera, const HeadCoupling& coupling, double across_mm) {
  const Vec3 eye_mm = eyeOf(coupling, across_mm);
  set(&vtkCamera::SetPosition, camera, *coupling.patientFromScreen * eye_mm);
  set(&vtkCamera::SetFocalPoint, camera, *coupling.patientFromScreen * Vec3{eye_mm.x, eye_mm.y, 0});
  set(&vtkCamera::SetViewUp, camera, coupling.patientFromScreen->linear.column[1]);
}

void lookThroughScreen(vtkCamera& camera, const HeadCoupling& coupling, double across_mm) {
  const Vec3 eye_mm = eyeOf(coupling, across_mm);
  const double near_mm = camera.GetClippingRange()[0], far_mm = camera.GetClippingRange()[1];
  const double w = coupling.width_mm, h = coupling.height_mm;
  // The frustum through the screen's edges (as glFrustum): it has the same shape at any distance, so that units of the
  // screen suffice.
  const double matrix[16] = {2 * eye_mm.z / w,
                             0,
                             -2 * eye_mm.x / w,
                             0,  //
                             0,
                             2 * eye_mm.z / h,
                             -2 * eye_mm.y / h,
                             0,  //
                             0,
                             0,
                             -(far_mm + near_mm) / (far_mm - near_mm),
                             -2 * far_mm * near_mm / (far_mm - near_mm),  //
                             0,
                             0,
                             -1,
                             0};
  vtkNew<vtkMatrix4x4> projection;
  projection->DeepCopy(matrix);
  camera.SetExplicitProjectionTransformMatrix(projection);
  camera.UseExplicitProjectionTransformMatrixOn();
}

void useStereo(vtkRenderWindow& window, Stereo stereo) {
  switch (stereo) {
    case Stereo::Off:
      window.StereoRenderOff();
      return;
    case Stereo::Anaglyph:
      window.SetStereoTypeToAnaglyph();
      break;
    case Stereo::SideBySide:
      window.SetStereoTypeToSplitViewportHorizontal();
      break;
    case Stereo::Interlaced:
      window.SetStereoTypeToInterlaced();
      break;
    case Stereo::Checkerboard:
      window.SetStereoTypeToCheckerboard();
      break;
    case Stereo::LeftEye:
      window.SetStereoTypeToLeft();
      break;
    case Stereo::RightEye:
      window.SetStereoTypeToRight();
      break;
    case Stereo::QuadBuffer:
      window.SetStereoTypeToCrystalEyes();
      break;
  }
  window.StereoRenderOn();
}

}  // namespace insonate::views
