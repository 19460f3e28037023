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
namespace {

struct Stop {
  double hu, opacity, red, green, blue;
};
constexpr Stop kBone[] = {{150, 0, 0.55, 0.32, 0.24},
                          {250, 0.12, 0.78, 0.62, 0.46},
                          {500, 0.55, 0.92, 0.85, 0.72},
                          {1500, 0.9, 0.98, 0.96, 0.92}};
constexpr Stop kSoftTissue[] = {{-400, 0, 0.62, 0.42, 0.34},   {-150, 0.06, 0.70, 0.50, 0.41},
                                {-20, 0.10, 0.75, 0.45, 0.38}, {60, 0.25, 0.72, 0.33, 0.28},
                                {200, 0.35, 0.85, 0.72, 0.58}, {700, 0.8, 0.95, 0.92, 0.85}};

void useStops(vtkVolumeProperty& property, std::span<const Stop> stops) {
  vtkNew<vtkPiecewiseFunction> opacity;
  vtkNew<vtkColorTransferFunction> colour;
  for (const Stop& stop : stops) {
    opacity->AddPoint(stop.hu, stop.opacity);
    colour->AddRGBPoint(stop.hu, stop.red, stop.green, stop.blue);
  }
  property.SetScalarOpacity(opacity);
  property.SetColor(colour);
}

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
  // Jitter would hide rings, and make no two pictures alike.
  mapper_->UseJitteringOff();
  mapper_->AutoAdjustSampleDistancesOff();
}

CtVolumeActor::~CtVolumeActor() {
  if (shown_) renderer_.RemoveVolume(volume_);
}

void CtVolumeActor::set(const VtkCase* patient, CtLook look) {
  const bool show = patient && look != CtLook::Off;
  if (show != shown_) show ? renderer_.AddVolume(volume_) : renderer_.RemoveVolume(volume_);
  shown_ = show;
  if (!show) return;
  // The mapper is given the grid's own frame and placed by a matrix: its support of directions varies.
  const VolumeGeometry& grid = patient->patient().ct.geometry;
  vtkNew<vtkImageData> unturned;
  unturned->SetDimensions(patient->ct()->GetDimensions());
  unturned->SetSpacing(patient->ct()->GetSpacing());
  unturned->GetPointData()->SetScalars(patient->ct()->GetPointData()->GetScalars());
  mapper_->SetInputData(unturned);
  volume_->SetUserMatrix(vtkMatrix({grid.direction, grid.origin_mm}));
  const double finest_mm = std::min({grid.spacing_mm.x, grid.spacing_mm.y, grid.spacing_mm.z});
  volume_->GetProperty()->SetScalarOpacityUnitDistance(std::max(1.0, finest_mm));
  useStops(*volume_->GetProperty(),
           look == CtLook::Bone ? std::span<const Stop>(kBone) : std::span<const Stop>(kSoftTissue));
  setSampling();
}

void CtVolumeActor::setCoarse(bool coarse) {
  coarse_ = coarse;
  setSampling();
}

void CtVolumeActor::setSoftware(bool software) {
  software_ = software;
  setSampling();
}

void CtVolumeActor::setSampling() {
  vtkImageData* image = vtkImageData::SafeDownCast(mapper_->GetDataSetInput());
  if (!image) return;
  const double* spacing = image->GetSpacing();
  const double finest_mm = std::min({spacing[0], spacing[1], spacing[2]});
  mapper_->SetSampleDistance(static_cast<float>(finest_mm * (coarse_ ? 3 : software_ ? 1.5 : 0.7)));
  mapper_->SetImageSampleDistance(coarse_ ? (software_ ? 6.F : 2.F) : software_ ? 2.F : 1.F);
}

void CtVolumeActor::setClipping(const std::optional<ClippingPlane>& plane) {
  clip(*mapper_, plane);
}

}  // namespace insonate::views
