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

/// What VTK draws of a scene. Belongs to whoever renders its window: that may be another thread than the one which says
/// what is to be seen.
class SceneStage {
 public:
  /// `news` is called on other threads when a better picture can be drawn.
  SceneStage(vtkRenderer& renderer, std::function<void()> news);

  void attach(vtkRenderWindow& window);
  void detach(vtkRenderWindow& window);

  /// The next pictures show this. What is given gets the memory of a state that is shown no more.
  void show(SceneState& next);
  /// Whether the renderer's picture that begins needs layout().
  bool due() const { return due_ || (now_.coupling && now_.stereo != Stereo::Off); }
  void layout();

  /// What was drawn last lacks nothing.
  bool exact() const { return !now_.moving && ct_.exact(); }
  /// What draws, in OpenGL's words; empty before the first picture.
  const std::string& graphics() const { return graphics_; }

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
