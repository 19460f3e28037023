#include <insonate/views/Theme.h>
#include <insonate/views/View.h>

#include <vtkCommand.h>
#include <vtkRenderWindow.h>

#include <algorithm>

namespace insonate::views {

View::View() {
  renderer_->SetBackground(0, 0, 0);
  renderer_->AddObserver(vtkCommand::StartEvent, this, &View::rendererStarts);
}

View::~View() {
  if (window_) window_->RemoveRenderer(renderer_);
}

void View::attach(vtkRenderWindow* window) {
  detach();
  window_ = window;
  if (!window_) return;
  window_->AddRenderer(renderer_);
  attached(*window_);
  changed();
}

void View::detach() {
  if (!window_) return;
  detached(*window_);
  window_->RemoveRenderer(renderer_);
  window_ = nullptr;
}

void View::resize(int width_px, int height_px, double scale) {
  width_px_ = std::max(1, width_px), height_px_ = std::max(1, height_px);
  scale_ = std::clamp(scale, 0.5, 8.0);
  changed();
}

vtkRenderWindow* View::window() {
  return window_;
}

void View::render() {
  if (!window_) return;
  if (renderElsewhere_) return renderElsewhere_();
  publishState();
  adoptState();
  draw();
}

void View::draw() {
  window_->Render();
}

void View::finish() {
  // A drawing thread has already read its finished pixels.
  if (window_ && !renderElsewhere_) window_->WaitForCompletion();
}

void View::changed() {
  stale_ = true;
  requestRender();
}

void View::requestRender() const {
  if (renderRequested_) renderRequested_();
}

void View::setWakeListener(std::function<void()> listener) {
  const std::lock_guard lock(waking_);
  wake_ = std::move(listener);
}

void View::wake() {
  const std::lock_guard lock(waking_);
  if (wake_) wake_();
}

void View::rendererStarts() {
  const bool stale = stale_.exchange(false);
  if (stale || isStale()) layout();
}

}  // namespace insonate::views
