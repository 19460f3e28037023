#pragma once

#include <insonate/views/Input.h>
#include <insonate/views/Theme.h>

#include <vtkNew.h>

#include <span>

class vtkActor2D;
class vtkCellArray;
class vtkPoints;
class vtkPolyData;
class vtkRenderer;
class vtkUnsignedCharArray;

namespace insonate::views {

struct Stroke {
  Color color = theme::kText;
  double width_px = 1;
  double opacity = 1;
};

/// Draws lines and small shapes over a view, in display pixels. Edges are antialiased over one pixel, so that they are
/// smooth even without multisampling. Later shapes cover earlier ones.
class Lines {
 public:
  explicit Lines(vtkRenderer& renderer, int layer = 1);
  ~Lines();

  void begin(int height_px);
  void segment(DisplayPoint from, DisplayPoint to, const Stroke& stroke);
  void polyline(std::span<const DisplayPoint> points, const Stroke& stroke, bool closed = false);
  void circle(DisplayPoint center, double radius_px, const Stroke& stroke);
  void disc(DisplayPoint center, double radius_px, Color color, double opacity = 1);
  void triangle(DisplayPoint a, DisplayPoint b, DisplayPoint c, Color color);
  void end();

 private:
  long long point(double x, double y, Color color, double opacity);

  vtkNew<vtkPoints> points_;
  vtkNew<vtkUnsignedCharArray> colors_;
  vtkNew<vtkCellArray> cells_;
  vtkNew<vtkPolyData> data_;
  vtkNew<vtkActor2D> actor_;
  vtkRenderer& renderer_;
  int height_px_ = 1;
};

}  // namespace insonate::views
