#include "NeedleModel.h"

#include <vtkCylinderSource.h>
#include <vtkMatrix4x4.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <cmath>

namespace insonate::views {

NeedleModel::NeedleModel(vtkRenderer& renderer) : renderer_(renderer) {
  // A unit cylinder along y; the matrix gives it length, thickness and place.
  vtkNew<vtkCylinderSource> cylinder;
  cylinder->SetRadius(0.5);
  cylinder->SetHeight(1);
  cylinder->SetCenter(0, 0.5, 0);
  cylinder->SetResolution(16);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(cylinder->GetOutputPort());
  shaft_->SetMapper(mapper);
  shaft_->GetProperty()->SetAmbient(0.35);
  shaft_->GetProperty()->SetDiffuse(0.65);
  shaft_->SetVisibility(false);
  renderer_.AddActor(shaft_);
}

NeedleModel::~NeedleModel() {
  renderer_.RemoveActor(shaft_);
}

void NeedleModel::set(const std::optional<SceneView::Needle>& needle) {
  const Vec3 along_mm = needle ? needle->hub_mm - needle->tip_mm : Vec3{};
  const double length_mm = norm(along_mm);
  shaft_->SetVisibility(length_mm > 0);
  if (length_mm <= 0) return;
  const Vec3 y = along_mm / length_mm;
  const Vec3 x = normalized(cross(y, std::abs(y.x) < 0.7 ? Vec3{1, 0, 0} : Vec3{0, 0, 1}));
  const double d = needle->diameter_mm;
  shaft_->SetUserMatrix(vtkMatrix({Mat3{{x * d, along_mm, cross(x, y) * d}}, needle->tip_mm}));
  shaft_->GetProperty()->SetColor(needle->colour.red / 255.0, needle->colour.green / 255.0,
                                  needle->colour.blue / 255.0);
}

}  // namespace insonate::views
