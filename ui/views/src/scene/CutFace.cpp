#include "CutFace.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkPoints.h>
#include <vtkProperty.h>
#include <vtkTypeInt32Array.h>

#include <cstring>
#include <span>

namespace insonate::views {
namespace {

/// Flat colors look brighter than shaded ones; the wall is darker than the inside.
constexpr double kInside = 0.92, kWall = 0.5;
/// Draws the wall before the inside.
constexpr double kWallLift_mm = 0.03;

vtkSmartPointer<vtkPoints> lifted(const std::vector<float>& from_mm, Vec3 by_mm) {
  vtkNew<vtkFloatArray> array;
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(from_mm.size() / 3));
  float* to = array->GetPointer(0);
  for (std::size_t k = 0; k < from_mm.size(); ++k) to[k] = from_mm[k] + float(by_mm[int(k % 3)]);
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetData(array);
  return points;
}

vtkSmartPointer<vtkCellArray> cellsOf(std::span<const std::uint32_t> corners, int each) {
  const auto count = static_cast<vtkIdType>(corners.size()) / each;
  vtkNew<vtkTypeInt32Array> offsets, array;
  offsets->SetNumberOfValues(count + 1);
  for (vtkIdType k = 0; k <= count; ++k) offsets->SetValue(k, static_cast<vtkTypeInt32>(each * k));
  array->SetNumberOfValues(each * count);
  std::memcpy(array->GetPointer(0), corners.data(), corners.size_bytes());
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, array);
  return cells;
}

}  // namespace

CutFace::CutFace() {
  for (const auto& [mapper, data, actor] : {std::tuple{insideMapper_.Get(), inside_.Get(), insideActor_.Get()},
                                            std::tuple{wallMapper_.Get(), wall_.Get(), wallActor_.Get()}}) {
    mapper->SetInputData(data);
    mapper->ScalarVisibilityOff();
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    actor->VisibilityOff();
    // Faces change with the plane, and must not change the bounds of the scene.
    actor->UseBoundsOff();
  }
}

void CutFace::add(vtkRenderer& renderer) {
  renderer.AddActor(insideActor_);
  renderer.AddActor(wallActor_);
}

void CutFace::remove(vtkRenderer& renderer) {
  renderer.RemoveActor(insideActor_);
  renderer.RemoveActor(wallActor_);
}

void CutFace::setColor(Color color) {
  const double red = color.red / 255.0, green = color.green / 255.0, blue = color.blue / 255.0;
  insideActor_->GetProperty()->SetColor(kInside * red, kInside * green, kInside * blue);
  wallActor_->GetProperty()->SetColor(kWall * red, kWall * green, kWall * blue);
}

void CutFace::setFilled(bool filled) {
  filled_ = filled;
  show();
}

void CutFace::setVisible(bool visible) {
  visible_ = visible;
  show();
}

void CutFace::setWall(double width_px) {
  wallActor_->GetProperty()->SetLineWidth(float(width_px));
}

void CutFace::show() {
  insideActor_->SetVisibility(there_ && visible_ && filled_);
  wallActor_->SetVisibility(there_ && visible_);
}

void CutFace::cut(const Surface& surface, const ClippingPlane& plane, double lift_mm) {
  cut_.cut(surface, plane);
  there_ = !cut_.outline().empty();
  if (there_) {
    const Vec3 out = -normalized(plane.normal);
    inside_->SetPoints(lifted(cut_.points_mm(), out * lift_mm));
    inside_->SetPolys(cellsOf(cut_.triangles(), 3));
    wall_->SetPoints(lifted(cut_.points_mm(), out * (lift_mm + kWallLift_mm)));
    wall_->SetLines(cellsOf(cut_.outline(), 2));
  }
  show();
}

void CutFace::clear() {
  there_ = false;
  show();
}

}  // namespace insonate::views
