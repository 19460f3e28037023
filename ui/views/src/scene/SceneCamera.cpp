#include "SceneCamera.h"

#include <vtkCamera.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkRenderWindow.h>

#include <algorithm>
#include <cmath>

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
  // The frustum through the screen's edges (as glFrustum): the same shape at any distance, so screen units will do.
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
