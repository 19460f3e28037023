#pragma once

#include <insonate/views/SceneView.h>

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>

namespace insonate::views {

/// One label's surface, with a coarser one beside it where it is large.
class Structure {
 public:
  Structure();

  void setSurface(const Surface& surface, const Surface& coarse);
  void setColour(Colour colour);
  void setOpacity(double opacity);
  void setVisible(bool visible);
  void setCoarse(bool coarse);
  void setClipping(const std::optional<ClippingPlane>& plane);

  vtkActor* actor() { return actor_; }
  bool visible() const { return visible_ && opacity_ > 0; }
  bool translucent() const { return visible() && opacity_ < 1; }

 private:
  vtkNew<vtkActor> actor_;
  vtkNew<vtkPolyDataMapper> mapper_;
  vtkSmartPointer<vtkPolyData> fine_, coarse_;
  double opacity_ = 1;
  bool visible_ = true;
};

}  // namespace insonate::views
