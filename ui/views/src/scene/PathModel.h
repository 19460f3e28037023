#pragma once

#include <insonate/views/SceneOptions.h>

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <vector>

namespace insonate::views {

/// Lines in space, as tubes, so that they keep their place before and behind other things.
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
