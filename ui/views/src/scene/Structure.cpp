#include "Structure.h"

#include "Clipping.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkQuadricClustering.h>
#include <vtkShaderProperty.h>
#include <vtkTypeInt32Array.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <unordered_map>
#include <utility>

namespace insonate::views {
namespace {

/// Number of triangles above which a coarser surface is worth its memory.
constexpr vtkIdType kLargeTriangles = 12000;
/// Maximum number of triangles of the coarser surface.
constexpr double kCoarseTriangles = 10000;

vtkSmartPointer<vtkFloatArray> triples(std::span<const float> values) {
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size() / 3));
  std::memcpy(array->GetPointer(0), values.data(), values.size() / 3 * 3 * sizeof(float));
  return array;
}

vtkSmartPointer<vtkPolyData> withNormals(vtkPolyData* data) {
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(data);
  normals->SplittingOff();
  normals->ConsistencyOff();
  normals->Update();
  return normals->GetOutput();
}

vtkSmartPointer<vtkPolyData> polyData(const Surface& surface) {
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetData(triples(surface.points_mm));
  const auto count = static_cast<vtkIdType>(surface.triangles.size() / 3);
  vtkNew<vtkTypeInt32Array> offsets, corners;
  offsets->SetNumberOfValues(count + 1);
  for (vtkIdType k = 0; k <= count; ++k) offsets->SetValue(k, static_cast<vtkTypeInt32>(3 * k));
  corners->SetNumberOfValues(3 * count);
  std::memcpy(corners->GetPointer(0), surface.triangles.data(), std::size_t(3 * count) * sizeof(std::uint32_t));
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, corners);
  data->SetPoints(points);
  data->SetPolys(cells);
  if (surface.normals.size() != surface.points_mm.size()) return withNormals(data);
  data->GetPointData()->SetNormals(triples(surface.normals));
  return data;
}

/// Clear in the middle and denser toward the outline, like glass: the shape is visible without hiding the inside.
void showAsGlass(vtkActor& actor, bool glass) {
  vtkShaderProperty& shader = *actor.GetShaderProperty();
  shader.ClearAllFragmentShaderReplacements();
  if (!glass) return;
  shader.AddFragmentShaderReplacement("//VTK::Light::Impl", true,
                                      "//VTK::Light::Impl\n"
                                      "  float slant = 1.0 - abs(normalVCVSOutput.z);\n"
                                      "  fragOutput0.a = min(1.0, opacity * (0.25 + 2.0 * slant * slant));\n"
                                      "  fragOutput0.rgb = mix(fragOutput0.rgb, 1.3 * diffuseColor, 0.6 * slant);\n",
                                      false);
}

double area_mm2(vtkPolyData* data) {
  double sum = 0;
  const auto cells = vtk::TakeSmartPointer(data->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell()) {
    const vtkIdType* corners = nullptr;
    vtkIdType count = 0;
    cells->GetCurrentCell(count, corners);
    double a[3], b[3], c[3];
    data->GetPoint(corners[0], a), data->GetPoint(corners[1], b), data->GetPoint(corners[2], c);
    sum += norm(cross({b[0] - a[0], b[1] - a[1], b[2] - a[2]}, {c[0] - a[0], c[1] - a[1], c[2] - a[2]})) / 2;
  }
  return sum;
}

/// Gives the coarse points the mean normal of the fine points in their bin, since folded triangles have no reliable
/// normal.
void takeNormals(vtkPolyData& fine, vtkPolyData& coarse, const double box[6], const int divisions[3]) {
  const auto binOf = [&](const double point[3]) {
    std::int64_t bin = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double share = (point[axis] - box[2 * axis]) / std::max(1e-9, box[2 * axis + 1] - box[2 * axis]);
      bin = bin * divisions[axis] + std::clamp(static_cast<int>(share * divisions[axis]), 0, divisions[axis] - 1);
    }
    return bin;
  };
  std::unordered_map<std::int64_t, Vec3> sums;
  vtkDataArray& from = *fine.GetPointData()->GetNormals();
  for (vtkIdType k = 0; k < fine.GetNumberOfPoints(); ++k) {
    const double* normal = from.GetTuple3(k);
    Vec3& sum = sums[binOf(fine.GetPoint(k))];
    sum = sum + Vec3{normal[0], normal[1], normal[2]};
  }
  vtkDataArray& to = *coarse.GetPointData()->GetNormals();
  for (vtkIdType k = 0; k < coarse.GetNumberOfPoints(); ++k) {
    const auto found = sums.find(binOf(coarse.GetPoint(k)));
    if (found == sums.end() || norm(found->second) < 0.1) continue;
    const Vec3 normal = normalized(found->second);
    to.SetTuple3(k, normal.x, normal.y, normal.z);
  }
}

vtkSmartPointer<vtkPolyData> coarser(vtkPolyData* fine) {
  const double triangles = static_cast<double>(fine->GetNumberOfPolys());
  // Size of bins in edges of the fine triangles: small for small structures, whose thin parts would break.
  const double edge_mm = std::sqrt(2.31 * area_mm2(fine) / triangles);
  const double bin_mm = edge_mm * std::clamp(std::sqrt(triangles / kCoarseTriangles), 1.5, 8.0);
  const double* box = fine->GetBounds();
  int divisions[3];
  for (int axis = 0; axis < 3; ++axis)
    divisions[axis] = std::clamp(static_cast<int>((box[2 * axis + 1] - box[2 * axis]) / bin_mm), 2, 1000);
  vtkNew<vtkPolyData> shape;
  shape->SetPoints(fine->GetPoints());
  shape->SetPolys(fine->GetPolys());
  vtkNew<vtkQuadricClustering> bins;
  bins->SetInputData(shape);
  bins->SetNumberOfDivisions(divisions);
  bins->AutoAdjustNumberOfDivisionsOff();
  bins->UseInternalTrianglesOff();
  bins->Update();
  vtkSmartPointer<vtkPolyData> coarse = withNormals(bins->GetOutput());
  takeNormals(*fine, *coarse, box, divisions);
  return coarse;
}

}  // namespace

Structure::Structure() {
  mapper_->ScalarVisibilityOff();
  actor_->SetMapper(mapper_);
  vtkProperty& look = *actor_->GetProperty();
  look.SetInterpolationToPhong();
  look.SetAmbient(0.12);
  look.SetDiffuse(0.85);
  look.SetSpecular(0.12);
  look.SetSpecularPower(25);
}

void Structure::setShape(std::shared_ptr<const SceneShape> shape) {
  shape_ = std::move(shape);
  fine_ = polyData(shape_->fine.surface());
  coarse_ = nullptr;
  if (!shape_->coarse.corners.empty()) {
    coarse_ = polyData(shape_->coarse.surface());
  } else if (fine_->GetNumberOfPolys() > kLargeTriangles) {
    coarse_ = coarser(fine_);
  }
  mapper_->SetInputData(fine_);
  open_ = true;
}

void Structure::add(vtkRenderer& renderer) {
  renderer.AddActor(actor_);
  face_.add(renderer);
}

void Structure::remove(vtkRenderer& renderer) {
  renderer.RemoveActor(actor_);
  face_.remove(renderer);
}

void Structure::close(double lift_mm) {
  if (!open_ || (plane_ && !visible())) return;
  open_ = false;
  if (!plane_) return face_.clear();
  // Uses the fine surface, since coarse ones need not be closed.
  face_.cut(shape_->fine.surface(), *plane_, lift_mm);
}

void Structure::setColor(Color color) {
  actor_->GetProperty()->SetColor(color.red / 255.0, color.green / 255.0, color.blue / 255.0);
  face_.setColor(color);
}

void Structure::setOpacity(double opacity) {
  opacity_ = std::clamp(opacity, 0.0, 1.0);
  actor_->GetProperty()->SetOpacity(opacity_);
  // Draws only the near side of a translucent surface, which needs no sorting; the far side would only obscure the
  // inside.
  actor_->GetProperty()->SetBackfaceCulling(opacity_ < 1);
  showAsGlass(*actor_, opacity_ < 1);
  // The inside of a translucent structure is visible: only the wall is drawn.
  face_.setFilled(opacity_ == 1);
  setVisible(visible_);
}

void Structure::setVisible(bool shown) {
  visible_ = shown;
  actor_->SetVisibility(visible());
  face_.setVisible(visible());
}

void Structure::setCoarse(bool coarse) {
  mapper_->SetInputData(coarse && coarse_ ? coarse_ : fine_);
}

void Structure::setClipping(const std::optional<ClippingPlane>& plane) {
  clip(*mapper_, plane);
  const auto same = [](const ClippingPlane& a, const ClippingPlane& b) {
    return a.point_mm == b.point_mm && a.normal == b.normal;
  };
  open_ = open_ || plane.has_value() != plane_.has_value() || (plane && !same(*plane, *plane_));
  plane_ = plane;
}

}  // namespace insonate::views
