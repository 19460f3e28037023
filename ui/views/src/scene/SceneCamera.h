#pragma once

#include "SceneState.h"

class vtkCamera;

namespace insonate::views {

/// Places the camera so that a box (VTK order: x low, x high, ...) fills a view of this aspect ratio, seen from one
/// side.
void lookAt(vtkCamera& camera, Viewpoint from, const double box[6], double widthOverHeight);

/// placeOf() reads, and stand() sets, the position of a camera.
CameraPlace placeOf(vtkCamera& camera);
void stand(vtkCamera& camera, const CameraPlace& place);

/// Sets the near and far clipping distances so that the box lies between them.
void enclose(vtkCamera& camera, const double box[6]);

/// Completes the data of a head-coupled view: computes the screen's height from the view's size, and the screen's pose
/// from the default camera.
HeadCoupling placed(HeadCoupling coupling, vtkCamera& usual, int width_px, int height_px);

/// Places the camera at the eye, looking perpendicular to the screen's plane. `across_mm` is the distance of the eye to
/// the right of the midpoint between both eyes.
void standBeforeScreen(vtkCamera& camera, const HeadCoupling& coupling, double across_mm);

/// Sets the camera's projection so that the eye looks through the screen as through a window. Call it after
/// standBeforeScreen() and after the clipping range is set. (VTK's own off-axis projection ignores the camera's
/// position, and with it lights and clipping range.)
void lookThroughScreen(vtkCamera& camera, const HeadCoupling& coupling, double across_mm);

void useStereo(vtkRenderWindow& window, Stereo stereo);

}  // namespace insonate::views
