#include <insonate/core/ThreadPriority.h>
#include <insonate/views/DrawingThread.h>
#include <insonate/views/View.h>

#include <vtkOpenGLRenderWindow.h>

#include <chrono>
#include <utility>

namespace insonate::views {

std::unique_lock<std::mutex> DrawingThread::pause() {
  static std::mutex drawing;
  return std::unique_lock(drawing);
}

DrawingThread::DrawingThread(View& view, std::function<void()> drawn)
    : view_(view), drawn_(std::move(drawn)), window_(vtkSmartPointer<vtkRenderWindow>::New()) {
  window_->SetOffScreenRendering(true);
  window_->SetShowWindow(false);
  window_->SetMultiSamples(0);
  view_.attach(window_);
  view_.renderElsewhere_ = [this] { drawNow(); };
}

DrawingThread::~DrawingThread() {
  view_.renderElsewhere_ = nullptr;
  if (!thread_.joinable()) {
    view_.detach();
    return;
  }
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

/// Looks up OpenGL's functions here, since that writes to data that all windows share. A software driver has threads,
/// which get the priority of the thread that makes the context.
void DrawingThread::start() {
  const auto alone = pause();
  window_->SetSize(view_.width_px(), view_.height_px());
  if (auto* graphics = vtkOpenGLRenderWindow::SafeDownCast(window_))
    std::thread([this, graphics] {
      if (view_.hasLowerPriority()) lowerThreadPriority();
      graphics->Initialize();
      graphics->ReleaseCurrent();
    }).join();
  thread_ = std::thread([this] { run(); });
}

std::uint64_t DrawingThread::requestFrame() {
  if (!thread_.joinable()) start();
  std::uint64_t wish = 0;
  {
    const std::lock_guard lock(mutex_);
    view_.publishState();
    width_px_ = view_.width_px(), height_px_ = view_.height_px();
    wish = ++wanted_;
  }
  changed_.notify_all();
  return wish;
}

void DrawingThread::drawNow() {
  const std::uint64_t wish = requestFrame();
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return done_ >= wish; });
}

bool DrawingThread::takeFrame(Drawn& drawn) {
  const std::lock_guard lock(mutex_);
  if (!std::exchange(isReady_, false)) return false;
  std::swap(drawn, ready_);
  return true;
}

void DrawingThread::run() {
  if (view_.hasLowerPriority()) lowerThreadPriority();
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return ends_ || done_ < wanted_; });
    if (ends_) break;
    const std::uint64_t wish = wanted_;
    const int width_px = width_px_, height_px = height_px_;
    view_.adoptState();
    lock.unlock();
    draw(width_px, height_px, making_);
    making_.wish = wish;
    lock.lock();
    std::swap(making_, ready_);
    isReady_ = true;
    done_ = wish;
    lock.unlock();
    changed_.notify_all();
    drawn_();
    lock.lock();
  }
  lock.unlock();
  // Graphics resources must be released by the thread that made them.
  const auto alone = pause();
  view_.detach();
  window_ = nullptr;
}

void DrawingThread::draw(int width_px, int height_px, Drawn& into) {
  const auto alone = pause();
  const auto start = std::chrono::steady_clock::now();
  const int* size = window_->GetSize();
  if (size[0] != width_px || size[1] != height_px) window_->SetSize(width_px, height_px);
  view_.draw();
  reader_.read(*window_, into.pixels);
  into.took_ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace insonate::views
