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

/// Draws a view on its own thread, so that the window's thread never waits for an image: the window passes the view's
/// state, and receives the finished pixels. For the window's thread, like the view.
class DrawingThread {
 public:
  /// canDrawOnThread() of the view must be true, and the view must outlive this object. The view is attached to a
  /// separate OpenGL window, which no other thread uses after the first want(). `drawn` is called on the drawing thread
  /// after each image.
  DrawingThread(View& view, std::function<void()> drawn);
  /// Waits until the image in progress is finished.
  ~DrawingThread();
  DrawingThread(const DrawingThread&) = delete;
  DrawingThread& operator=(const DrawingThread&) = delete;

  /// Waits for images in progress; no drawing thread draws while the returned lock is held. For code that opens or
  /// closes another OpenGL window: VTK and its driver have global state, and closing one window while another was drawn
  /// has corrupted it.
  [[nodiscard]] static std::unique_lock<std::mutex> pause();

  /// Requests an image of the view's present state, to be drawn after the image in progress; replaces earlier requests
  /// that wait. Returns the number of the request, counted from 1.
  std::uint64_t want();
  /// Requests a drawing, and waits until it is done.
  void drawNow();

  struct Drawn {
    Pixels pixels;
    std::uint64_t wish = 0;  ///< number of the request whose state the image shows
    double took_ms = 0;      ///< from the beginning of drawing until the pixels were read
  };
  /// Exchanges the last image for `drawn`, whose memory is used for the next image. Returns false, without a change, if
  /// there is no new image since the last call.
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

  Drawn making_;  ///< used by the drawing thread only
  std::thread thread_;
};

}  // namespace insonate::views
