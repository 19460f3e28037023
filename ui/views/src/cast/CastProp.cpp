#include "CastProp.h"

#include "../scene/PatientBox.h"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkObjectFactory.h>
#include <vtkRayCastImageDisplayHelper.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace insonate::views {
namespace {

/// Time limit for the rays of one moving frame.
constexpr double kQuick_ms = 20;
/// Pixels between two rays along a side.
constexpr double kWidest = 8, kStepOfSpacing = 0.5;
/// Weight of the last measurement for the next frame.
constexpr double kTrust = 0.3;
/// Depth nearest to the eye: rays through the CT end at what is drawn in front of it.
constexpr float kFront = 1e-6F;

}  // namespace

vtkStandardNewMacro(CastProp)

    CastProp::CastProp()
    : display_(vtk::TakeSmartPointer(vtkRayCastImageDisplayHelper::New())) {
  display_->PreMultipliedColorsOn();
}

CastProp::~CastProp() {
  refiner_.reset();
}

void CastProp::setCase(const std::shared_ptr<const VtkCase>& patient) {
  case_ = patient;
  if (refiner_) refiner_->rest();
  if (case_) ctBox(*case_, box_);
}

void CastProp::setTransferFunction(const TransferFunction& function) {
  transfer_ = function;
  quick_.look = nullptr;
}

void CastProp::setMoving(bool moving) {
  moving_ = moving;
  if (moving && refiner_) refiner_->rest();
}

double CastProp::spacingFor(double pixels, double perRay_ms) {
  const double spacing = std::sqrt(pixels * perRay_ms / kQuick_ms);
  return std::clamp(std::ceil(spacing / kStepOfSpacing) * kStepOfSpacing, 1.0, kWidest);
}

double* CastProp::GetBounds() {
  return case_ ? box_ : nullptr;
}

/// Tells whether there is anything to cast.
bool CastProp::ready() {
  if (!case_) return false;
  if (!refiner_)
    refiner_ = std::make_unique<Refiner>([this] {
      fresh_ = true;
      if (news_) news_();
    });
  refiner_->prepare(case_->shared());
  const auto volume = refiner_->volume();
  // A volume of another grid is unusable; one of the same grid in other memory is used until the new one is ready.
  if (!volume || volume->patient->ct.geometry != case_->patient().ct.geometry) return false;
  if (!quick_.look || quick_.look->volume != volume) quick_.look = std::make_shared<const CastLook>(volume, transfer_);
  return true;
}

void CastProp::aim(vtkRenderer& renderer, int x, int y) {
  CastView& view = quick_.view;
  vtkCamera& camera = *renderer.GetActiveCamera();
  vtkMatrix4x4::Invert(camera.GetCompositeProjectionTransformMatrix(renderer.GetTiledAspectRatio(), -1, 1)->GetData(),
                       view.patientFromSeen.data());
  const vtkMatrix4x4& turned = *camera.GetViewTransformMatrix();
  for (int row = 0; row < 3; ++row)
    view.patientFromCamera[std::size_t(row)] = {turned.GetElement(row, 0), turned.GetElement(row, 1),
                                                turned.GetElement(row, 2)};
  view.clipping = clipping_;
  view.depth.resize(std::size_t(view.width) * view.height);
  renderer.GetRenderWindow()->GetZbufferData(x, y, x + view.width - 1, y + view.height - 1, view.depth.data());
}

void CastProp::castQuickly() {
  const double pixels = double(quick_.view.width) * quick_.view.height;
  const double spacing = spacingFor(pixels, perRay_ms_);
  quick_.across = std::max(1, int(std::lround(quick_.view.width / spacing)));
  quick_.up = std::max(1, int(std::lround(quick_.view.height / spacing)));
  quick_.coarse = true;
  const auto start = std::chrono::steady_clock::now();
  castAll(quick_, rgba_);
  const double took_ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  perRay_ms_ += kTrust * (took_ms / (double(quick_.across) * quick_.up) - perRay_ms_);
}

int CastProp::RenderVolumetricGeometry(vtkViewport* viewport) {
  auto* renderer = vtkRenderer::SafeDownCast(viewport);
  exact_ = fresh_ = false;
  if (!renderer || !ready()) return 0;
  int x = 0, y = 0;
  renderer->GetTiledSizeAndOrigin(&quick_.view.width, &quick_.view.height, &x, &y);
  if (quick_.view.width < 1 || quick_.view.height < 1) return 0;
  aim(*renderer, x, y);
  const int eye = renderer->GetActiveCamera()->GetLeftEye() ? 1 : 0;
  const auto picture = moving_ ? nullptr : refiner_->picture(eye);
  exact_ = picture && picture->task.showsAs(quick_);
  if (exact_) {
    show(*renderer, picture->task, picture->rgba);
    return 1;
  }
  castQuickly();
  show(*renderer, quick_, rgba_);
  if (!moving_ && !refiner_->makes(eye, quick_)) {
    CastTask wanted = quick_;
    wanted.across = wanted.view.width, wanted.up = wanted.view.height;
    wanted.coarse = false;
    refiner_->want(eye, std::move(wanted));
  }
  return 1;
}

void CastProp::show(vtkRenderer& renderer, const CastTask& task, const std::vector<std::uint8_t>& rgba) {
  int size[2] = {task.across, task.up}, origin[2] = {0, 0};
  // VTK has no constant pointers; this code only reads the data.
  display_->RenderTexture(nullptr, &renderer, size, size, size, origin, kFront, const_cast<std::uint8_t*>(rgba.data()));
}

void CastProp::ReleaseGraphicsResources(vtkWindow* window) {
  display_->ReleaseGraphicsResources(window);
}

}  // namespace insonate::views
