#pragma once

#include <insonate/views/SceneView.h>

#include <vtkActor.h>
#include <vtkNew.h>

namespace insonate::views {

/// A straight shaft, ending in its tip.
class NeedleModel {
 public:
  explicit NeedleModel(vtkRenderer& renderer);
  ~NeedleModel();

  void set(const std::optional<SceneView::Needle>& needle);

 private:
  vtkRenderer& renderer_;
  vtkNew<vtkActor> shaft_;
};

}  // namespace insonate::views
