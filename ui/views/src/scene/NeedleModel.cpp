#include "NeedleModel.h"

#include <vtkCellArray.h>
#include <vtkMatrix4x4.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <cmath>
#include <initializer_list>
#include <numbers>
#include <utility>

namespace insonate::views {
namespace {

constexpr int kSides = 24;
/// Angle between the bevel and the shaft of an introducer needle.
constexpr double kBevel_deg = 20;
/// Color of an 18 G needle's hub (ISO 6009).
constexpr Color kHub{0xd6, 0x86, 0xa8};
constexpr Color kLumen{0x2a, 0x30, 0x37};

struct Ring {
  double z_mm, radius_mm;
};

/// Rings about z joined to a surface; the last one ends in the bevel, if that has a length.
vtkSmartPointer<vtkPolyData> turned(std::initializer_list<Ring> rings, double bevel_mm) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkIdType first = 0;
  for (const Ring& ring : rings) {
    const bool last = &ring == rings.end() - 1;
    for (int k = 0; k < kSides; ++k) {
      const double turn = 2 * std::numbers::pi * k / kSides, y = std::sin(turn);
      const double back_mm = last ? bevel_mm * (1 - y) / 2 : 0;
      points->InsertNextPoint(ring.radius_mm * std::cos(turn), ring.radius_mm * y, ring.z_mm - back_mm);
      const vtkIdType next = (k + 1) % kSides;
      const vtkIdType quad[4] = {first + k, first + next, first + next - kSides, first + k - kSides};
      if (first > 0) cells->InsertNextCell(4, quad);
    }
    first += kSides;
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(cells);
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(data);
  normals->SetFeatureAngle(50);
  normals->Update();
  return normals->GetOutput();
}

/// The opening of the bevel, an ellipse.
vtkSmartPointer<vtkPolyData> opening(double radius_mm, double bevel_mm) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(kSides);
  for (int k = 0; k < kSides; ++k) {
    const double turn = 2 * std::numbers::pi * k / kSides, y = std::sin(turn);
    points->InsertNextPoint(radius_mm * std::cos(turn), radius_mm * y, -bevel_mm * (1 - y) / 2);
    cells->InsertCellPoint(k);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(cells);
  return data;
}

void show(vtkActor& actor, vtkPolyData* shape) {
  vtkPolyDataMapper::SafeDownCast(actor.GetMapper())->SetInputData(shape);
}

void paint(vtkActor& actor, Color color) {
  actor.GetProperty()->SetColor(color.red / 255.0, color.green / 255.0, color.blue / 255.0);
}

}  // namespace

NeedleModel::NeedleModel(vtkRenderer& renderer) : renderer_(renderer) {
  for (vtkActor* part : {shaft_.Get(), bevel_.Get(), hub_.Get()}) {
    vtkNew<vtkPolyDataMapper> mapper;
    part->SetMapper(mapper);
    part->GetProperty()->SetAmbient(0.35);
    part->GetProperty()->SetDiffuse(0.65);
    part->SetVisibility(false);
    renderer_.AddActor(part);
  }
  shaft_->GetProperty()->SetSpecular(0.5);
  shaft_->GetProperty()->SetSpecularPower(30);
  paint(*bevel_, kLumen);
  paint(*hub_, kHub);
}

NeedleModel::~NeedleModel() {
  for (vtkActor* part : {shaft_.Get(), bevel_.Get(), hub_.Get()}) renderer_.RemoveActor(part);
}

void NeedleModel::shape(double length_mm, double diameter_mm) {
  const bool same = std::exchange(length_mm_, length_mm) == length_mm;
  if (std::exchange(diameter_mm_, diameter_mm) == diameter_mm && same) return;
  const double r = diameter_mm / 2, bevel_mm = diameter_mm / std::tan(kBevel_deg * std::numbers::pi / 180);
  show(*shaft_, turned({{-length_mm, r}, {0, r}}, bevel_mm));
  show(*bevel_, opening(r * 0.8, bevel_mm * 0.8));
  const double z = -length_mm;
  show(*hub_,
       turned({{z - 26, 0.1}, {z - 26, 3.6}, {z - 24, 3.6}, {z - 23.9, 2.9}, {z - 8, 2.6}, {z, 1.1}, {z, r}}, 0));
}

void NeedleModel::set(const std::optional<SceneView::Needle>& needle) {
  const bool there = needle && needle->length_mm > 0 && needle->diameter_mm > 0;
  for (vtkActor* part : {shaft_.Get(), bevel_.Get(), hub_.Get()}) part->SetVisibility(there);
  if (!there) return;
  shape(needle->length_mm, needle->diameter_mm);
  const auto matrix = vtkMatrix(needle->patientFromNeedle);
  for (vtkActor* part : {shaft_.Get(), bevel_.Get(), hub_.Get()}) part->SetUserMatrix(matrix);
  paint(*shaft_, needle->color);
}

}  // namespace insonate::views
