#pragma once

#include <insonate/views/Pixels.h>

#include <vtkSmartPointer.h>

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <thread>

class vtkRenderWindow;

namespace insonate::views {

class View;

/// Draws a view on a thread of its own, so that the window's thread never waits for an image: the window passes the
/// state, and finished pixels come back. For the window's thread, like the view.
class DrawingThread {
 public:
  /// The view must say canDrawOnThread() and outlive this; it is attached to a window of its own, which no other
  /// thread uses after the first image is wanted. `drawn` is called on the drawing thread after each picture.
  DrawingThread(View& view, std::function<void()> drawn);
  /// Waits for the image in work, if any.
  ~DrawingThread();
  DrawingThread(const DrawingThread&) = delete;
  DrawingThread& operator=(const DrawingThread&) = delete;

  /// While this is held, no thread draws. For code that opens or closes another OpenGL window: VTK and its driver keep
  /// global state, which closing one window has corrupted while another was drawn. Waits for running images.
  [[nodiscard]] static std::unique_lock<std::mutex> pause();

  /// Has drawn what the view shows now, after the image in work; the latest wish counts. The answer numbers the wish,
  /// rising from 1.
  std::uint64_t want();
  /// Requests a drawing, and waits until it is done.
  void drawNow();

  struct Drawn {
    Pixels pixels;
    std::uint64_t wish = 0;  ///< the image shows what was to be seen with this one
    double took_ms = 0;      ///< from its beginning to its pixels
  };
  /// Exchanges the last image for `drawn`, whose memory serves the next. False, without a change, if there is none
  /// since the last call.
  bool take(Drawn& drawn);

 private:
  void start();
  void run();
  void draw(int width_px, int height_px, Drawn& into);

  View& view_;
  std::function<void()> drawn_;
  vtkSmartPointer<vtkRenderWindow> window_;
  PixelReader reader_;
  std::mutex mutex_;
  std::condition_variable changed_;
  // Guarded by the mutex
  int width_px_ = 1, height_px_ = 1;
  std::uint64_t wanted_ = 0, done_ = 0;
  Drawn ready_;
  bool isReady_ = false, ends_ = false;

  Drawn making_;  ///< of the thread
  std::thread thread_;
};

}  // namespace insonate::views
