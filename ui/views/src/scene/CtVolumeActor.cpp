#include "CtVolumeActor.h"

#include "Clipping.h"

#include <vtkColorTransferFunction.h>
#include <vtkGPUVolumeRayCastMapper.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>
#include <vtkRenderer.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cmath>

namespace insonate::views {
namespace {

/// What a processor casts for a picture at rest while the window waits.
constexpr double kStillRays = 70'000;

}  // namespace

CtVolumeActor::CtVolumeActor(vtkRenderer& renderer)
    : renderer_(renderer), mapper_(vtkSmartPointer<vtkGPUVolumeRayCastMapper>::New()) {
  volume_->SetMapper(mapper_);
  vtkVolumeProperty& property = *volume_->GetProperty();
  property.SetInterpolationTypeToLinear();
  property.ShadeOn();
  property.SetAmbient(0.35);
  property.SetDiffuse(0.85);
  property.SetSpecular(0.1);
  property.SetScalarOpacity(opacity_);
  property.SetColor(colour_);
  property.SetScalarOpacityUnitDistance(1);
  // Jitter would hide rings, and make no two pictures alike.
  mapper_->UseJitteringOff();
  mapper_->AutoAdjustSampleDistancesOff();
}

CtVolumeActor::~CtVolumeActor() {
  if (shown_) renderer_.RemoveVolume(volume_);
}

void CtVolumeActor::setCase(const VtkCase* patient) {
  hasCase_ = patient != nullptr;
  if (patient) {
    // The mapper is given the grid's own frame and placed by a matrix: its support of directions varies.
    const VolumeGeometry& grid = patient->patient().ct.geometry;
    vtkNew<vtkImageData> unturned;
    unturned->SetDimensions(patient->ct()->GetDimensions());
    unturned->SetSpacing(patient->ct()->GetSpacing());
    unturned->GetPointData()->SetScalars(patient->ct()->GetPointData()->GetScalars());
    mapper_->SetInputData(unturned);
    volume_->SetUserMatrix(vtkMatrix({grid.direction, grid.origin_mm}));
    setSampling();
  }
  show();
}

void CtVolumeActor::setVisible(bool visible) {
  visible_ = visible;
  show();
}

void CtVolumeActor::show() {
  const bool show = hasCase_ && visible_;
  if (show != shown_) show ? renderer_.AddVolume(volume_) : renderer_.RemoveVolume(volume_);
  shown_ = show;
}

void CtVolumeActor::setTransferFunction(const TransferFunction& function) {
  opacity_->RemoveAllPoints();
  colour_->RemoveAllPoints();
  for (const TransferNode& node : function.nodes) {
    opacity_->AddPoint(node.hu, node.opacity);
    colour_->AddRGBPoint(node.hu, node.colour.red / 255.0, node.colour.green / 255.0, node.colour.blue / 255.0);
  }
}

void CtVolumeActor::setCoarse(bool coarse) {
  coarse_ = coarse;
  setSampling();
}

void CtVolumeActor::setSoftware(bool software) {
  software_ = software;
  setSampling();
}

void CtVolumeActor::setPixels(double pixels) {
  if (pixels == pixels_) return;
  pixels_ = pixels;
  setSampling();
}

void CtVolumeActor::setSampling() {
  vtkImageData* image = vtkImageData::SafeDownCast(mapper_->GetDataSetInput());
  if (!image) return;
  const double* spacing = image->GetSpacing();
  const double finest_mm = std::min({spacing[0], spacing[1], spacing[2]});
  mapper_->SetSampleDistance(static_cast<float>(finest_mm * (coarse_ ? 3 : software_ ? 1.5 : 0.7)));
  const double still = software_ ? std::clamp(std::sqrt(pixels_ / kStillRays), 2.0, 4.0) : 1;
  mapper_->SetImageSampleDistance(coarse_ ? (software_ ? 3.F : 2.F) : static_cast<float>(still));
}

void CtVolumeActor::setClipping(const std::optional<ClippingPlane>& plane) {
  clip(*mapper_, plane);
}

}  // namespace insonate::views
