#include "MovingDetail.h"

#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>
#include <vtk_glew.h>

#include <algorithm>
#include <cmath>

namespace insonate::views {
namespace {

/// Between these limits the detail does not change, so that it does not oscillate. The window's own work adds to the
/// time of an image.
constexpr double kTooSlow_ms = 70, kQuickEnough_ms = 30, kWanted_ms = 50;
constexpr double kShrink[MovingDetail::kSteps] = {1, 1.25, 1.5, 2, 2.5, 3, 4, 5};

}  // namespace

MovingDetail::MovingDetail(int step) : step_(step) {}
MovingDetail::~MovingDetail() = default;

double MovingDetail::shrinkOf(int step) {
  return kShrink[std::clamp(step, 0, kSteps - 1)];
}

double MovingDetail::shrink() const {
  return moving_ ? shrinkOf(step_) : 1;
}

int MovingDetail::nextStep(int step, double took_ms) {
  if (took_ms <= kTooSlow_ms) return took_ms < kQuickEnough_ms ? std::max(0, step - 1) : step;
  // Nearly all of the time is proportional to the number of pixels.
  const double wanted = shrinkOf(step) * std::sqrt(took_ms / kWanted_ms);
  while (step < kSteps - 1 && shrinkOf(step) < wanted) ++step;
  return step;
}

void MovingDetail::starts(vtkRenderer& renderer, bool moving) {
  moving_ = moving;
  start_ = std::chrono::steady_clock::now();
  const int* size = renderer.GetRenderWindow()->GetSize();
  const double width = std::max(1, size[0]), height = std::max(1, size[1]);
  renderer.SetViewport(0, 0, std::ceil(width / shrink()) / width, std::ceil(height / shrink()) / height);
}

void MovingDetail::ends(vtkRenderer& renderer) {
  if (!moving_) return;
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer.GetRenderWindow());
  if (!window) return;
  const int width = window->GetSize()[0], height = window->GetSize()[1];
  if (shrink() > 1) {
    const int across = int(std::ceil(width / shrink())), up = int(std::ceil(height / shrink()));
    enlarge(*window, across, up);
  }
  window->WaitForCompletion();
  step_ = nextStep(step_, std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count());
}

/// OpenGL cannot copy within an image, so that its corner is copied through another.
void MovingDetail::enlarge(vtkOpenGLRenderWindow& window, int across, int up) {
  const int width = window.GetSize()[0], height = window.GetSize()[1];
  vtkOpenGLFramebufferObject& picture = *window.GetRenderFramebuffer();
  vtkOpenGLState& state = *window.GetState();
  state.PushFramebufferBindings();
  corner_->SetContext(&window);
  // As large as the window, so that another step does not allocate.
  const int* size = corner_->GetLastSize();
  if (corner_->GetNumberOfColorAttachments() == 0)
    corner_->PopulateFramebuffer(width, height, true, 1, VTK_UNSIGNED_CHAR, false, 0, 0);
  else if (size[0] != width || size[1] != height)
    corner_->Resize(width, height);
  const auto copy = [&](vtkOpenGLFramebufferObject& from, vtkOpenGLFramebufferObject& to, int toWidth, int toHeight) {
    from.Bind(GL_READ_FRAMEBUFFER);
    from.ActivateReadBuffer(0);
    to.Bind(GL_DRAW_FRAMEBUFFER);
    to.ActivateDrawBuffer(0);
    state.vtkglBlitFramebuffer(0, 0, across, up, 0, 0, toWidth, toHeight, GL_COLOR_BUFFER_BIT, GL_LINEAR);
  };
  // The scissor test also applies to this copy.
  vtkOpenGLState::ScopedglEnableDisable scissor(&state, GL_SCISSOR_TEST);
  state.vtkglDisable(GL_SCISSOR_TEST);
  copy(picture, *corner_, across, up);
  copy(*corner_, picture, width, height);
  state.PopFramebufferBindings();
}

void MovingDetail::release(vtkRenderWindow& window) {
  corner_->ReleaseGraphicsResources(&window);
}

}  // namespace insonate::views
