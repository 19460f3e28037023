#pragma once

#include <vtkNew.h>
#include <vtkRenderer.h>

class vtkRenderWindow;

namespace insonate::views {

/// A small cube with the letters of the patient's directions, in the lower left corner; it turns with the scene.
class OrientationCube {
 public:
  OrientationCube();

  void attach(vtkRenderWindow& window);
  void detach(vtkRenderWindow& window);
  /// `size_px`: side of the square corner in which the cube is drawn.
  void place(int width_px, int height_px, double size_px);
  void follow(vtkCamera& camera);
  vtkRenderer* renderer() { return renderer_; }

 private:
  vtkNew<vtkRenderer> renderer_;
};

}  // namespace insonate::views
