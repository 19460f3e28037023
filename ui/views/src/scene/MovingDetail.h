#pragma once

#include <vtkNew.h>

#include <chrono>

class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkRenderWindow;

namespace insonate::views {

/// Keeps a moving scene fast: the scene is drawn at reduced size in a corner of its window and then enlarged. The
/// reduction depends on the durations of the last frames. Fewer pixels help most if there is no graphics card. Frames
/// of a scene at rest are not reduced.
class MovingDetail {
 public:
  explicit MovingDetail(int step = 0);
  ~MovingDetail();

  /// Call starts() at the beginning of a window's frame, and ends() at the end of the renderer's.
  void starts(vtkRenderer& renderer, bool moving);
  void ends(vtkRenderer& renderer);
  void release(vtkRenderWindow& window);

  /// Number of window pixels per drawn pixel, along each axis.
  double shrink() const;

  /// Returns the step of reduction for the next frame, if a frame with the step `step` took `took_ms`.
  static int nextStep(int step, double took_ms);
  static constexpr int kSteps = 8;
  static double shrinkOf(int step);

 private:
  void enlarge(vtkOpenGLRenderWindow& window, int across, int up);

  vtkNew<vtkOpenGLFramebufferObject> corner_;
  std::chrono::steady_clock::time_point start_;
  int step_;
  bool moving_ = false;
};

}  // namespace insonate::views
