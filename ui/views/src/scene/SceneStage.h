#pragma once

#include "CtVolumeActor.h"
#include "ImagePlane.h"
#include "MovingDetail.h"
#include "NeedleModel.h"
#include "OrientationCube.h"
#include "PathModel.h"
#include "ProbeModel.h"
#include "SceneState.h"
#include "Structure.h"
#include "TrayModel.h"

#include <vtkCamera.h>

#include <functional>
#include <map>
#include <string>

namespace insonate::views {

/// The VTK objects of a scene. Used only on the thread that renders the scene's window, which need not be the thread
/// that changes the scene's state.
class SceneStage {
 public:
  /// `news` is called on other threads when a better image can be drawn.
  SceneStage(vtkRenderer& renderer, std::function<void()> news);

  void attach(vtkRenderWindow& window);
  void detach(vtkRenderWindow& window);

  /// Sets the state of the next frames. `next` receives the memory of a former state.
  void show(SceneState& next);
  /// Tells whether layout() must be called before the renderer's next frame.
  bool due() const { return due_ || (now_.coupling && now_.stereo != Stereo::Off); }
  void layout();

  /// Tells whether the last frame was complete.
  bool exact() const { return !now_.moving && ct_.exact(); }
  /// OpenGL's name of the renderer; empty before the first frame.
  const std::string& rendererName() const { return graphics_; }

 private:
  void pictureStarts();
  void pictureEnds();
  void showStructures();
  void showCt();
  void showProbe();
  void aim();

  vtkRenderer& renderer_;
  vtkRenderWindow* window_ = nullptr;
  std::map<std::uint8_t, Structure> structures_;
  CtVolumeActor ct_;
  ImagePlane plane_;
  ProbeModel probe_;
  NeedleModel needle_;
  PathModel path_;
  TrayModel tray_;
  OrientationCube cube_;
  MovingDetail detail_;
  vtkNew<vtkCamera> usual_, coupled_;
  unsigned long startObserver_ = 0;
  SceneState now_, before_;
  std::string graphics_;
  bool due_ = false;
};

}  // namespace insonate::views
