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
  Colour colour = theme::kText;
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
  void circle(DisplayPoint centre, double radius_px, const Stroke& stroke);
  void disc(DisplayPoint centre, double radius_px, Colour colour, double opacity = 1);
  void triangle(DisplayPoint a, DisplayPoint b, DisplayPoint c, Colour colour);
  void end();

 private:
  long long point(double x, double y, Colour colour, double opacity);

  vtkNew<vtkPoints> points_;
  vtkNew<vtkUnsignedCharArray> colours_;
  vtkNew<vtkCellArray> cells_;
  vtkNew<vtkPolyData> data_;
  vtkNew<vtkActor2D> actor_;
  vtkRenderer& renderer_;
  int height_px_ = 1;
};

}  // namespace insonate::views
