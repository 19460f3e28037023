#pragma once

#include "PlaneCut.h"

#include <insonate/views/Theme.h>

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>

namespace insonate::views {

/// The cut face of a structure: its inside in its color, and its wall as a line around it.
class CutFace {
 public:
  CutFace();

  void add(vtkRenderer& renderer);
  void remove(vtkRenderer& renderer);
  void setColour(Colour colour);
  /// Sets whether the inside is filled; the wall is always drawn.
  void setFilled(bool filled);
  void setVisible(bool visible);
  /// Cuts a surface; `lift_mm` moves the face toward the removed side, so that of two nested structures the inner one
  /// is seen.
  void cut(const Surface& surface, const ClippingPlane& plane, double lift_mm);
  void clear();
  /// Line width, in device pixels.
  void setWall(double width_px);

 private:
  void show();

  PlaneCut cut_;
  vtkNew<vtkPolyData> inside_, wall_;
  vtkNew<vtkPolyDataMapper> insideMapper_, wallMapper_;
  vtkNew<vtkActor> insideActor_, wallActor_;
  bool filled_ = true, visible_ = true, there_ = false;
};

}  // namespace insonate::views
