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

  // State of the window's thread. The drawing thread does not need the data from `patient` on.
  SceneState state;
  std::shared_ptr<const VtkCase> patient;
  Clipping clipping;
  vtkNew<vtkCamera> usual, coupled;
  std::function<void()> structuresChanged;
  Viewpoint viewpoint = Viewpoint::Anterior;
  bool framed = false;  ///< true: the camera was placed so that all objects are visible
  Button held = Button::None;
  DisplayPoint last;

  // State that is passed from the window's thread to the drawing thread; the two threads never use it at the same time.
  SceneState handed;
  bool isHanded = false;

  // State of the drawing thread.
  SceneState taken;
  bool isTaken = false;

  // State that both threads use.
  std::atomic<bool> exact{false}, news{false};
  std::atomic<double> render_s{0};
  mutable std::mutex telling;
  std::string graphics;  ///< guarded by `telling`

  /// Declared last, so that the stage and its threads are destroyed first.
  SceneStage stage;
};

}  // namespace insonate::views
