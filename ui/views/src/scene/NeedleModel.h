#pragma once

#include <insonate/views/SceneView.h>

#include <vtkActor.h>
#include <vtkNew.h>

namespace insonate::views {

/// Model of a needle: a hollow shaft with its bevel, and the hub.
class NeedleModel {
 public:
  explicit NeedleModel(vtkRenderer& renderer);
  ~NeedleModel();

  void set(const std::optional<SceneView::Needle>& needle);

 private:
  void shape(double length_mm, double diameter_mm);

  vtkRenderer& renderer_;
  vtkNew<vtkActor> shaft_, bevel_, hub_;
  double length_mm_ = 0, diameter_mm_ = 0;  ///< dimensions of the present shapes
};

}  // namespace insonate::views
