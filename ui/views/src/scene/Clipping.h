#pragma once

#include <insonate/views/SceneView.h>

#include <vtkAbstractMapper.h>
#include <vtkNew.h>
#include <vtkPlane.h>

namespace insonate::views {

/// Clips a mapper, so that it draws only the side to which the plane's normal points. Without a plane it draws
/// everything.
inline void clip(vtkAbstractMapper& mapper, const std::optional<ClippingPlane>& plane) {
  mapper.RemoveAllClippingPlanes();
  if (!plane) return;
  vtkNew<vtkPlane> keep;
  keep->SetOrigin(plane->point_mm.x, plane->point_mm.y, plane->point_mm.z);
  keep->SetNormal(plane->normal.x, plane->normal.y, plane->normal.z);
  mapper.AddClippingPlane(keep);
}

}  // namespace insonate::views
