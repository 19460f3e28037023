#pragma once

#include <vtkNew.h>
#include <vtkRenderer.h>

class vtkRenderWindow;

namespace insonate::views {

/// A small cube with the patient's letters in the lower left corner, turning with the scene.
class OrientationCube {
 public:
  OrientationCube();

  void attach(vtkRenderWindow& window);
  void detach(vtkRenderWindow& window);
  /// `size_px` is the corner's side.
  void place(int width_px, int height_px, double size_px);
  void follow(vtkCamera& camera);
  vtkRenderer* renderer() { return renderer_; }

 private:
  vtkNew<vtkRenderer> renderer_;
};

}  // namespace insonate::views
