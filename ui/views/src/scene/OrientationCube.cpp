#include "OrientationCube.h"

#include <insonate/views/Theme.h>

#include <vtkAnnotatedCubeActor.h>
#include <vtkCamera.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>

#include <algorithm>

namespace insonate::views {
namespace {

void color(vtkProperty& property, Color c) {
  property.SetColor(c.red / 255.0, c.green / 255.0, c.blue / 255.0);
}

}  // namespace

OrientationCube::OrientationCube() {
  vtkNew<vtkAnnotatedCubeActor> cube;
  cube->SetXPlusFaceText("L");
  cube->SetXMinusFaceText("R");
  cube->SetYPlusFaceText("P");
  cube->SetYMinusFaceText("A");
  cube->SetZPlusFaceText("H");
  cube->SetZMinusFaceText("F");
  // The letters are upright for a patient whose head is up.
  cube->SetXFaceTextRotation(0);
  cube->SetYFaceTextRotation(0);
  cube->SetZFaceTextRotation(-90);
  cube->SetFaceTextScale(0.62);
  cube->SetTextEdgesVisibility(0);
  color(*cube->GetCubeProperty(), theme::kLine);
  for (vtkProperty* letter :
       {cube->GetXPlusFaceProperty(), cube->GetXMinusFaceProperty(), cube->GetYPlusFaceProperty(),
        cube->GetYMinusFaceProperty(), cube->GetZPlusFaceProperty(), cube->GetZMinusFaceProperty()}) {
    color(*letter, theme::kText);
    letter->SetAmbient(0.6);
    letter->SetDiffuse(0.4);
  }
  renderer_->AddActor(cube);
  renderer_->SetLayer(1);
  renderer_->InteractiveOff();
}

void OrientationCube::attach(vtkRenderWindow& window) {
  window.SetNumberOfLayers(std::max(2, window.GetNumberOfLayers()));
  window.AddRenderer(renderer_);
}

void OrientationCube::detach(vtkRenderWindow& window) {
  window.RemoveRenderer(renderer_);
}

void OrientationCube::place(int width_px, int height_px, double size_px) {
  renderer_->SetViewport(0, 0, std::min(1.0, size_px / width_px), std::min(1.0, size_px / height_px));
}

void OrientationCube::follow(vtkCamera& camera) {
  vtkCamera& own = *renderer_->GetActiveCamera();
  const double* direction = camera.GetDirectionOfProjection();
  const double distance = 4.6;
  own.SetFocalPoint(0, 0, 0);
  own.SetPosition(-distance * direction[0], -distance * direction[1], -distance * direction[2]);
  own.SetViewUp(camera.GetViewUp());
  own.SetClippingRange(0.1, 20);
}

}  // namespace insonate::views
