#include "TissueDrawing.h"

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
#include <cstdio>

namespace insonate::views {
namespace {

constexpr int kMaxLines = 40;        ///< in one direction
constexpr double kStrength = 0.6;    ///< opacity of the colors if pressure is at least a quarter of the scale
constexpr double kShrinks = 0.3;     ///< the scale shrinks only if a smaller share of it is used
constexpr double kMaxCells = 0.985;  ///< share of the cells within the scale; at the edges of the face the pressure is
                                     ///< unbounded

/// Equal steps of pressure are perceived as equal, also by color-blind eyes (viridis).
constexpr Color kColors[] = {
    {0x44, 0x01, 0x54}, {0x3b, 0x52, 0x8b}, {0x21, 0x91, 0x8c}, {0x5e, 0xc9, 0x62}, {0xfd, 0xe7, 0x25}};

Color colorOf(double share) {
  constexpr int kLast = int(std::size(kColors)) - 1;
  const double at = std::clamp(share, 0.0, 1.0) * kLast;
  const int low = std::min(int(at), kLast - 1);
  const auto mix = [&](std::uint8_t a, std::uint8_t b) { return std::uint8_t(std::lround(a + (at - low) * (b - a))); };
  const Color &a = kColors[low], &b = kColors[low + 1];
  return {mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue)};
}

DisplayPoint onDisplay(ImagePoint point, const PicturePlane& plane) {
  return {std::clamp(plane.origin.x + point.lateral_mm * plane.across_px, plane.left_px, plane.right_px),
          std::clamp(plane.origin.y + point.axial_mm * plane.down_px, plane.top_px, plane.bottom_px)};
}

/// The next of 1, 2, 5, 10, ... upward.
double rounded(double value) {
  double step = 1;
  for (int k = 0; step < value && k < 12; ++k) step *= k % 3 == 1 ? 2.5 : 2;
  return step;
}

}  // namespace

TissueDrawing::TissueDrawing(vtkRenderer& renderer) : renderer_(renderer), lines_(renderer), texts_(renderer) {
  colors_->SetNumberOfComponents(4);
  data_->SetPoints(points_);
  data_->SetPolys(cells_);
  data_->GetPointData()->SetScalars(colors_);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(data_);
  actor_->SetMapper(mapper);
  // In the image's layer: over the image, as it was added later, and below all lines.
  actor_->SetLayerNumber(0);
  renderer_.AddActor2D(actor_);
}

TissueDrawing::~TissueDrawing() {
  renderer_.RemoveActor2D(actor_);
}

void TissueDrawing::draw(const TissueOverlay& tissue, bool grid, bool pressure, const PicturePlane& plane, double scale,
                         int height_px) {
  points_->Reset();
  colors_->Reset();
  cells_->Reset();
  lines_.begin(height_px);
  texts_.begin(height_px);
  const std::size_t nodes = std::size_t(std::max(0, tissue.columns)) * std::max(0, tissue.rows);
  if (tissue.columns > 1 && tissue.rows > 1 && tissue.nodes.size() == nodes) {
    const std::size_t cells = std::size_t(tissue.columns - 1) * (tissue.rows - 1);
    if (pressure && tissue.pressure_kPa.size() == cells) {
      chooseTop(tissue);
      drawPressure(tissue, plane, height_px);
      drawLegend(plane, scale);
    }
    if (grid) drawGrid(tissue, plane, scale);
  }
  lines_.end();
  texts_.end();
  actor_->SetVisibility(cells_->GetNumberOfCells() > 0);
  points_->Modified();
  colors_->Modified();
  cells_->Modified();
  data_->Modified();
}

void TissueDrawing::drawGrid(const TissueOverlay& tissue, const PicturePlane& plane, double scale) {
  const Stroke stroke{theme::kLink, scale, 0.45};
  const int step = std::max(1, (std::max(tissue.columns, tissue.rows) + kMaxLines - 1) / kMaxLines);
  const auto line = [&](int column, int row, int byColumn, int byRow, int count) {
    DisplayPoint last{};
    for (int k = 0; k < count; ++k) {
      const std::size_t node = std::size_t(row + k * byRow) * tissue.columns + (column + k * byColumn);
      const DisplayPoint at = onDisplay(tissue.nodes[node], plane);
      const auto edge = [&](double DisplayPoint::*axis, double low, double high) {
        return last.*axis == at.*axis && (at.*axis == low || at.*axis == high);
      };
      // Points clamped to the image's edge are outside it.
      const bool outside = edge(&DisplayPoint::x, plane.left_px, plane.right_px) ||
                           edge(&DisplayPoint::y, plane.top_px, plane.bottom_px);
      if (k > 0 && !outside) lines_.segment(last, at, stroke);
      last = at;
    }
  };
  for (int row = 0; row < tissue.rows; row += step) line(0, row, 1, 0, tissue.columns);
  for (int column = 0; column < tissue.columns; column += step) line(column, 0, 0, 1, tissue.rows);
}

void TissueDrawing::chooseTop(const TissueOverlay& tissue) {
  sorted_.assign(tissue.pressure_kPa.begin(), tissue.pressure_kPa.end());
  const auto nearTop = sorted_.begin() + std::ptrdiff_t(kMaxCells * double(sorted_.size() - 1));
  std::nth_element(sorted_.begin(), nearTop, sorted_.end());
  const double most = *nearTop;
  if (most > top_kPa_ || most < kShrinks * top_kPa_) top_kPa_ = rounded(most);
}

void TissueDrawing::drawPressure(const TissueOverlay& tissue, const PicturePlane& plane, int height_px) {
  for (int row = 0; row + 1 < tissue.rows; ++row)
    for (int column = 0; column + 1 < tissue.columns; ++column) {
      const double share =
          tissue.pressure_kPa[std::size_t(row) * (tissue.columns - 1) + column] / std::max(1e-9, top_kPa_);
      if (!(share > 0.01)) continue;
      const std::size_t first = std::size_t(row) * tissue.columns + column, below = first + tissue.columns;
      const DisplayPoint corners[4] = {onDisplay(tissue.nodes[first], plane), onDisplay(tissue.nodes[first + 1], plane),
                                       onDisplay(tissue.nodes[below + 1], plane),
                                       onDisplay(tissue.nodes[below], plane)};
      if (std::abs((corners[2].x - corners[0].x) * (corners[3].y - corners[1].y) -
                   (corners[2].y - corners[0].y) * (corners[3].x - corners[1].x)) < 1e-6)
        continue;
      const Color color = colorOf(share);
      const double strength = kStrength * std::min(1.0, 4 * share);
      const unsigned char rgba[4] = {color.red, color.green, color.blue,
                                     static_cast<unsigned char>(std::lround(255 * strength))};
      cells_->InsertNextCell(4);
      for (const DisplayPoint& at : corners) {
        colors_->InsertNextTypedTuple(rgba);
        cells_->InsertCellPoint(points_->InsertNextPoint(at.x, height_px - at.y, 0));
      }
    }
}

void TissueDrawing::drawLegend(const PicturePlane& plane, double scale) {
  // Below the gray bar, and as wide.
  const double right = plane.right_px + 34 * scale, left = right - 10 * scale;
  const double height = std::min(0.35 * (plane.bottom_px - plane.top_px), 140 * scale);
  const double bottom = plane.bottom_px - 18 * scale, top = bottom - height;
  constexpr int kSteps = 64;
  for (int k = 0; k < kSteps; ++k) {
    const double y0 = top + height * k / kSteps, y1 = top + height * (k + 1) / kSteps;
    lines_.segment({left, (y0 + y1) / 2}, {right, (y0 + y1) / 2}, {colorOf(1 - (k + 0.5) / kSteps), y1 - y0 + 0.5, 1});
  }
  char words[24];
  std::snprintf(words, sizeof words, "%g kPa", top_kPa_);
  texts_.put({plane.right_px + 42 * scale, top - 3 * scale}, words,
             {11 * scale, theme::kText, false, Across::Right, Along::Bottom});
  texts_.put({right, bottom + 2 * scale}, "0", {11 * scale, theme::kText, false, Across::Right, Along::Top});
}

}  // namespace insonate::views
