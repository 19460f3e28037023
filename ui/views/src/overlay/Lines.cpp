#include "Lines.h"

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace insonate::views {

Lines::Lines(vtkRenderer& renderer, int layer) : renderer_(renderer) {
  colors_->SetNumberOfComponents(4);
  data_->SetPoints(points_);
  data_->SetPolys(cells_);
  data_->GetPointData()->SetScalars(colors_);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(data_);
  actor_->SetMapper(mapper);
  actor_->SetLayerNumber(layer);
  renderer_.AddActor2D(actor_);
}

Lines::~Lines() {
  renderer_.RemoveActor2D(actor_);
}

void Lines::begin(int height_px) {
  height_px_ = height_px;
  points_->Reset();
  colors_->Reset();
  cells_->Reset();
}

long long Lines::point(double x, double y, Color color, double opacity) {
  const auto alpha = static_cast<unsigned char>(std::lround(255 * std::clamp(opacity, 0.0, 1.0)));
  const unsigned char rgba[4] = {color.red, color.green, color.blue, alpha};
  colors_->InsertNextTypedTuple(rgba);
  return points_->InsertNextPoint(x, height_px_ - y, 0);
}

void Lines::segment(DisplayPoint from, DisplayPoint to, const Stroke& stroke) {
  const double dx = to.x - from.x, dy = to.y - from.y, length = std::hypot(dx, dy);
  if (length < 1e-9) return;
  const double nx = -dy / length, ny = dx / length;
  // Full strength inside, fading out over a pixel: four lines of points along the line.
  const double inner = std::max(0.0, stroke.width_px / 2 - 0.5), outer = stroke.width_px / 2 + 0.5;
  const double rails[4] = {-outer, -inner, inner, outer};
  const double strength = stroke.opacity * std::min(1.0, stroke.width_px);
  const double opacity[4] = {0, strength, strength, 0};
  vtkIdType ids[4][2];
  for (int r = 0; r < 4; ++r) {
    ids[r][0] = point(from.x + nx * rails[r], from.y + ny * rails[r], stroke.color, opacity[r]);
    ids[r][1] = point(to.x + nx * rails[r], to.y + ny * rails[r], stroke.color, opacity[r]);
  }
  for (int r = 0; r < 3; ++r) {
    const vtkIdType quad[4] = {ids[r][0], ids[r][1], ids[r + 1][1], ids[r + 1][0]};
    cells_->InsertNextCell(4, quad);
  }
}

void Lines::polyline(std::span<const DisplayPoint> points, const Stroke& stroke, bool closed) {
  for (std::size_t k = 1; k < points.size(); ++k) segment(points[k - 1], points[k], stroke);
  if (closed && points.size() > 2) segment(points.back(), points.front(), stroke);
}

void Lines::circle(DisplayPoint center, double radius_px, const Stroke& stroke) {
  constexpr int kSides = 48;
  std::vector<DisplayPoint> ring(kSides);
  for (int k = 0; k < kSides; ++k) {
    const double angle = 2 * std::numbers::pi * k / kSides;
    ring[k] = {center.x + radius_px * std::cos(angle), center.y + radius_px * std::sin(angle)};
  }
  polyline(ring, stroke, true);
}

void Lines::disc(DisplayPoint center, double radius_px, Color color, double opacity) {
  constexpr int kSides = 32;
  const vtkIdType middle = point(center.x, center.y, color, opacity);
  std::vector<vtkIdType> inner(kSides), outer(kSides);
  for (int k = 0; k < kSides; ++k) {
    const double c = std::cos(2 * std::numbers::pi * k / kSides), s = std::sin(2 * std::numbers::pi * k / kSides);
    const double r = std::max(0.0, radius_px - 0.5);
    inner[k] = point(center.x + r * c, center.y + r * s, color, opacity);
    outer[k] = point(center.x + (r + 1) * c, center.y + (r + 1) * s, color, 0);
  }
  for (int k = 0; k < kSides; ++k) {
    const int next = (k + 1) % kSides;
    const vtkIdType wedge[3] = {middle, inner[k], inner[next]};
    const vtkIdType rim[4] = {inner[k], outer[k], outer[next], inner[next]};
    cells_->InsertNextCell(3, wedge);
    cells_->InsertNextCell(4, rim);
  }
}

void Lines::triangle(DisplayPoint a, DisplayPoint b, DisplayPoint c, Color color) {
  const vtkIdType ids[3] = {point(a.x, a.y, color, 1), point(b.x, b.y, color, 1), point(c.x, c.y, color, 1)};
  cells_->InsertNextCell(3, ids);
  for (const auto& [from, to] : {std::pair{a, b}, {b, c}, {c, a}}) segment(from, to, {color, 1, 1});
}

void Lines::end() {
  actor_->SetVisibility(cells_->GetNumberOfCells() > 0);
  points_->Modified();
  colors_->Modified();
  cells_->Modified();
  data_->Modified();
}

}  // namespace insonate::views
