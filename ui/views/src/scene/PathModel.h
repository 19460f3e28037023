#pragma once

#include <insonate/views/SceneOptions.h>

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <vector>

namespace insonate::views {

/// Lines in space, drawn as tubes, so that lines and other objects hide each other correctly.
class PathModel {
 public:
  explicit PathModel(vtkRenderer& renderer);
  ~PathModel();

  void set(const std::vector<ScenePath>& paths);

 private:
  vtkRenderer& renderer_;
  vtkNew<vtkActor> actor_;
};

}  // namespace insonate::views
