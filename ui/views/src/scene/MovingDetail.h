#pragma once

#include <vtkNew.h>

#include <chrono>

class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkRenderWindow;

namespace insonate::views {

/// Keeps a moving scene fast: it is drawn into a corner of its window and enlarged from there, in steps that follow
/// from the times of the last images. That saves pixels, the main cost for a processor without a graphics card. Images
/// of a scene at rest are not affected.
class MovingDetail {
 public:
  explicit MovingDetail(int step = 0);
  ~MovingDetail();

  /// Call at the start of a window's image, and at the end of the renderer's.
  void starts(vtkRenderer& renderer, bool moving);
  void ends(vtkRenderer& renderer);
  void release(vtkRenderWindow& window);

  /// Window pixels to a drawn one, along a side.
  double shrink() const;

  /// The step to draw with next, when an image drawn with this one took so long.
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
