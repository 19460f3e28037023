#pragma once

#include "SceneState.h"

class vtkCamera;

namespace insonate::views {

/// Places the camera so that a box (VTK order: x low, x high, ...) fills a view of this shape, seen from one side.
void lookAt(vtkCamera& camera, Viewpoint from, const double box[6], double widthOverHeight);

/// Reads and sets the position of a camera.
CameraPlace placeOf(vtkCamera& camera);
void stand(vtkCamera& camera, const CameraPlace& place);

/// Near and far, so that the box lies between.
void enclose(vtkCamera& camera, const double box[6]);

/// Completes a coupling: the screen's height from the view's size, and its place from the default camera.
HeadCoupling placed(HeadCoupling coupling, vtkCamera& usual, int width_px, int height_px);

/// Places the camera at the eye, looking perpendicular to the screen's plane. `across_mm` is the eye's distance to the
/// right of the middle between the eyes.
void standBeforeScreen(vtkCamera& camera, const HeadCoupling& coupling, double across_mm);

/// Then, with the camera's clipping range set: the screen is a window that the eye looks through. (VTK's own off-axis
/// projection forgets the camera's place, and with it lights and clipping range.)
void lookThroughScreen(vtkCamera& camera, const HeadCoupling& coupling, double across_mm);

void useStereo(vtkRenderWindow& window, Stereo stereo);

}  // namespace insonate::views
