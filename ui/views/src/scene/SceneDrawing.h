#pragma once

#include "SceneCamera.h"
#include "SceneStage.h"
#include "SceneState.h"

#include <vtkCamera.h>

#include <atomic>
#include <mutex>

namespace insonate::views {

struct SceneView::Drawing {
  Drawing(vtkRenderer& renderer, std::function<void()> wake)
      : stage(renderer, [this, wake = std::move(wake)] {
          news = true;
          wake();
        }) {}

  // State of the window's thread; from `patient` on, data that the drawing thread does not need.
  SceneState state;
  std::shared_ptr<const VtkCase> patient;
  Clipping clipping;
  vtkNew<vtkCamera> usual, coupled;
  std::function<void()> structuresChanged;
  Viewpoint viewpoint = Viewpoint::Anterior;
  bool framed = false;  ///< the camera was placed for visible objects
  Button held = Button::None;
  DisplayPoint last;

  // State on the way from the window's thread to the drawing thread; never used by both at once.
  SceneState handed;
  bool isHanded = false;

  // State of the drawing thread.
  SceneState taken;
  bool isTaken = false;

  // State of both threads.
  std::atomic<bool> exact{false}, news{false};
  std::atomic<double> render_s{0};
  mutable std::mutex telling;
  std::string graphics;  ///< guarded by `telling`

  /// Last member, so that it is destroyed first, with its threads.
  SceneStage stage;
};

}  // namespace insonate::views
