#pragma once

#include "PlaneCut.h"

#include <insonate/views/Theme.h>

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>

namespace insonate::views {

/// The face at which a plane cuts a structure: the inside in the structure's color, and the wall as a line around the
/// inside.
class CutFace {
 public:
  CutFace();

  void add(vtkRenderer& renderer);
  void remove(vtkRenderer& renderer);
  void setColor(Color color);
  /// Sets whether the inside is filled; the wall is always drawn.
  void setFilled(bool filled);
  void setVisible(bool visible);
  /// Cuts a surface. The face is moved by `lift_mm` toward the removed side, so that the inner one of two nested
  /// structures is visible.
  void cut(const Surface& surface, const ClippingPlane& plane, double lift_mm);
  void clear();
  /// Sets the width of the wall's line in device pixels.
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
