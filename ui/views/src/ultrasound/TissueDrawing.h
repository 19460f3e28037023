#pragma once

#include "../overlay/Lines.h"
#include "../overlay/Texts.h"

#include <insonate/views/UltrasoundView.h>

#include <vtkNew.h>

#include <vector>

class vtkActor2D;
class vtkCellArray;
class vtkPoints;
class vtkPolyData;
class vtkRenderer;
class vtkUnsignedCharArray;

namespace insonate::views {

/// Position and scale of the image on the display.
struct PicturePlane {
  double left_px = 0, top_px = 0, right_px = 0, bottom_px = 0;
  DisplayPoint origin;                  ///< display position of the point with lateral 0, axial 0
  double across_px = 10, down_px = 10;  ///< display pixels per mm; across_px is negative if mirrored
};

/// Draws mesh lines and pressure of the tissue over the image, and a color scale beside it. Allocates nothing while the
/// mesh keeps its size.
class TissueDrawing {
 public:
  explicit TissueDrawing(vtkRenderer& renderer);
  ~TissueDrawing();

  void draw(const TissueOverlay& tissue, bool grid, bool pressure, const PicturePlane& plane, double scale,
            int height_px);
  /// Pressure in kPa at the upper end of the color scale.
  double top_kPa() const { return top_kPa_; }

 private:
  void drawGrid(const TissueOverlay& tissue, const PicturePlane& plane, double scale);
  void drawPressure(const TissueOverlay& tissue, const PicturePlane& plane, int height_px);
  void drawLegend(const PicturePlane& plane, double scale);
  void chooseTop(const TissueOverlay& tissue);

  vtkNew<vtkPoints> points_;
  vtkNew<vtkUnsignedCharArray> colors_;
  vtkNew<vtkCellArray> cells_;
  vtkNew<vtkPolyData> data_;
  vtkNew<vtkActor2D> actor_;
  vtkRenderer& renderer_;
  Lines lines_;
  Texts texts_;
  std::vector<float> sorted_;
  double top_kPa_ = 1;
};

}  // namespace insonate::views
