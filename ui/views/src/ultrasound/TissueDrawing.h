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

/// Position of the image on the display, and its scale in mm.
struct PicturePlane {
  double left_px = 0, top_px = 0, right_px = 0, bottom_px = 0;
  DisplayPoint origin;                  ///< of lateral 0, axial 0
  double across_px = 10, down_px = 10;  ///< one mm; across below 0 where mirrored
};

/// Mesh lines and pressure of a tissue over the image, with the colors' scale beside it. Allocates nothing while the
/// mesh keeps its size.
class TissueDrawing {
 public:
  explicit TissueDrawing(vtkRenderer& renderer);
  ~TissueDrawing();

  void draw(const PictureTissue& tissue, bool grid, bool pressure, const PicturePlane& plane, double scale,
            int height_px);
  /// Upper end of the colors, kPa.
  double top_kPa() const { return top_kPa_; }

 private:
  void drawGrid(const PictureTissue& tissue, const PicturePlane& plane, double scale);
  void drawPressure(const PictureTissue& tissue, const PicturePlane& plane, int height_px);
  void drawLegend(const PicturePlane& plane, double scale);
  void chooseTop(const PictureTissue& tissue);

  vtkNew<vtkPoints> points_;
  vtkNew<vtkUnsignedCharArray> colours_;
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
