#include "TrayModel.h"

#include <insonate/views/VtkCase.h>

#include <vtkAppendPolyData.h>
#include <vtkCubeSource.h>
#include <vtkMatrix4x4.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

namespace insonate::views {
namespace {

constexpr double kSheet_mm = 1.5;
constexpr Color kSteel{0x8a, 0x96, 0xa0};
constexpr double kShaft_mm = 70;

}  // namespace

TrayModel::TrayModel(vtkRenderer& renderer) : renderer_(renderer), needle_(renderer) {
  const Vec3 size = SceneView::kTray_mm;
  vtkNew<vtkAppendPolyData> dish;
  const auto add = [&](Vec3 middle, Vec3 sides) {
    vtkNew<vtkCubeSource> sheet;
    sheet->SetCenter(middle.x, middle.y, middle.z);
    sheet->SetXLength(sides.x);
    sheet->SetYLength(sides.y);
    sheet->SetZLength(sides.z);
    sheet->Update();
    dish->AddInputData(sheet->GetOutput());
  };
  add({0, 0, 0}, {size.x, size.y, kSheet_mm});
  for (const double side : {-0.5, 0.5}) {
    add({side * size.x, 0, size.z / 2}, {kSheet_mm, size.y, size.z});
    add({0, side * size.y, size.z / 2}, {size.x, kSheet_mm, size.z});
  }
  dish->Update();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(dish->GetOutput());
  dish_->SetMapper(mapper);
  dish_->GetProperty()->SetColor(kSteel.red / 255.0, kSteel.green / 255.0, kSteel.blue / 255.0);
  dish_->GetProperty()->SetAmbient(0.3);
  dish_->GetProperty()->SetDiffuse(0.7);
  dish_->GetProperty()->SetSpecular(0.3);
  dish_->PickableOff();
  dish_->VisibilityOff();
  renderer_.AddActor(dish_);
}

TrayModel::~TrayModel() {
  renderer_.RemoveActor(dish_);
}

void TrayModel::set(const std::optional<Transform>& patientFromTray) {
  dish_->SetVisibility(patientFromTray.has_value());
  if (!patientFromTray) return needle_.set(std::nullopt);
  dish_->SetUserMatrix(vtkMatrix(*patientFromTray));
  // Along the tray, with hub and shaft in its middle.
  const Transform lying{{{Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{1, 0, 0}}}, {kShaft_mm / 2 + 13, 0, 4.5}};
  needle_.set(SceneView::Needle{.patientFromNeedle = *patientFromTray * lying, .length_mm = kShaft_mm});
}

}  // namespace insonate::views
