#include "PathModel.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTubeFilter.h>
#include <vtkUnsignedCharArray.h>

namespace insonate::views {
namespace {

constexpr int kTubeSides = 8;

}  // namespace

PathModel::PathModel(vtkRenderer& renderer) : renderer_(renderer) {
  actor_->GetProperty()->SetAmbient(0.5);
  actor_->GetProperty()->SetDiffuse(0.5);
  actor_->PickableOff();
  actor_->VisibilityOff();
  renderer_.AddActor(actor_);
}

PathModel::~PathModel() {
  renderer_.RemoveActor(actor_);
}

void PathModel::set(const std::vector<ScenePath>& paths) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  vtkNew<vtkDoubleArray> radii_mm;
  for (const ScenePath& path : paths) {
    if (path.points_mm.size() < 2) continue;
    lines->InsertNextCell(int(path.points_mm.size()));
    for (const Vec3& at : path.points_mm) {
      lines->InsertCellPoint(points->InsertNextPoint(at.x, at.y, at.z));
      radii_mm->InsertNextValue(path.radius_mm);
    }
    const unsigned char color[] = {path.color.red, path.color.green, path.color.blue};
    colors->InsertNextTypedTuple(color);
  }
  actor_->SetVisibility(points->GetNumberOfPoints() > 0);
  if (points->GetNumberOfPoints() == 0) return;
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(lines);
  data->GetCellData()->SetScalars(colors);
  data->GetPointData()->SetScalars(radii_mm);
  vtkNew<vtkTubeFilter> tubes;
  tubes->SetInputData(data);
  tubes->SetVaryRadiusToVaryRadiusByAbsoluteScalar();
  tubes->SetNumberOfSides(kTubeSides);
  tubes->CappingOn();
  tubes->Update();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(tubes->GetOutput());
  mapper->SetScalarModeToUseCellData();
  actor_->SetMapper(mapper);
}

}  // namespace insonate::views
