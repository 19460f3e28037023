#pragma once

#include "CutFace.h"
#include "SceneState.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>

namespace insonate::views {

/// The surface of one label. A large surface also has a version with lower resolution.
class Structure {
 public:
  Structure();

  void setShape(std::shared_ptr<const SceneShape> shape);
  void setColor(Color color);
  void setOpacity(double opacity);
  void setVisible(bool visible);
  void setCoarse(bool coarse);
  void setClipping(const std::optional<ClippingPlane>& plane);
  /// Updates the face at which the plane cuts the structure; has no effect if the face is up to date. `lift_mm`: as for
  /// CutFace::cut().
  void close(double lift_mm);

  void add(vtkRenderer& renderer);
  void remove(vtkRenderer& renderer);
  vtkActor* actor() { return actor_; }
  CutFace& face() { return face_; }
  bool visible() const { return visible_ && opacity_ > 0; }
  bool translucent() const { return visible() && opacity_ < 1; }

 private:
  vtkNew<vtkActor> actor_;
  vtkNew<vtkPolyDataMapper> mapper_;
  vtkSmartPointer<vtkPolyData> fine_, coarse_;
  std::shared_ptr<const SceneShape> shape_;
  CutFace face_;
  std::optional<ClippingPlane> plane_;
  bool open_ = false;  ///< true: the face does not match the plane
  double opacity_ = 1;
  bool visible_ = true;
};

}  // namespace insonate::views
