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

namespace insonate::views {
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
  property.SetColor(color_);
  property.SetScalarOpacityUnitDistance(1);
  // Jitter would hide rings, but make images differ from each other.
  mapper_->UseJitteringOff();
  mapper_->AutoAdjustSampleDistancesOff();
}

CtVolumeActor::~CtVolumeActor() {
  if (drawn_) renderer_.RemoveViewProp(drawn_);
}

void CtVolumeActor::setCase(const std::shared_ptr<const VtkCase>& patient) {
  hasCase_ = patient != nullptr;
  cast_->setCase(patient);
  if (patient) {
    // The mapper gets a volume with identity directions and a matrix, since its support of directions varies.
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
  shown_ = hasCase_ && visible_;
  vtkProp* wanted = !shown_ ? nullptr : software_ ? static_cast<vtkProp*>(cast_) : volume_;
  if (wanted == drawn_) return;
  if (drawn_) renderer_.RemoveViewProp(drawn_);
  if (wanted) renderer_.AddViewProp(wanted);
  drawn_ = wanted;
}

void CtVolumeActor::setTransferFunction(const TransferFunction& function) {
  cast_->setTransferFunction(function);
  opacity_->RemoveAllPoints();
  color_->RemoveAllPoints();
  for (const TransferNode& node : function.nodes) {
    opacity_->AddPoint(node.hu, node.opacity);
    color_->AddRGBPoint(node.hu, node.color.red / 255.0, node.color.green / 255.0, node.color.blue / 255.0);
  }
}

void CtVolumeActor::setCoarse(bool coarse) {
  coarse_ = coarse;
  cast_->setMoving(coarse);
  setSampling();
}

void CtVolumeActor::setSoftware(bool software) {
  software_ = software;
  show();
}

void CtVolumeActor::setSampling() {
  vtkImageData* image = vtkImageData::SafeDownCast(mapper_->GetDataSetInput());
  if (!image) return;
  const double* spacing = image->GetSpacing();
  const double finest_mm = std::min({spacing[0], spacing[1], spacing[2]});
  mapper_->SetSampleDistance(static_cast<float>(finest_mm * (coarse_ ? 3 : 0.7)));
  mapper_->SetImageSampleDistance(coarse_ ? 2.F : 1.F);
}

void CtVolumeActor::setClipping(const std::optional<ClippingPlane>& plane) {
  clip(*mapper_, plane);
  cast_->setClipping(plane);
}

}  // namespace insonate::views
