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

/// Draws a view on a thread of its own, so that the window's thread never waits for an image. The window's thread
/// passes the state of the view and receives the finished pixels. All functions are for the window's thread only.
class DrawingThread {
 public:
  /// View::canDrawOnThread() must be true, and the view must outlive this object. The view is attached to a separate
  /// OpenGL window, which only the drawing thread uses after the first requestFrame(). `drawn` is called on the drawing
  /// thread after each image.
  DrawingThread(View& view, std::function<void()> drawn);
  /// Waits until the image in progress is finished.
  ~DrawingThread();
  DrawingThread(const DrawingThread&) = delete;
  DrawingThread& operator=(const DrawingThread&) = delete;

  /// Waits for all images in progress. No drawing thread draws while the caller holds the returned lock. Hold the lock
  /// while another OpenGL window is opened or closed: VTK and the graphics driver have global state, which was
  /// corrupted when a window was closed during drawing.
  [[nodiscard]] static std::unique_lock<std::mutex> pause();

  /// Requests an image of the view's present state. The image is drawn after the image in progress; earlier requests
  /// that still wait are discarded. Returns the number of the request, counted from 1.
  std::uint64_t requestFrame();
  /// Requests an image and waits until it is drawn.
  void drawNow();

  struct Drawn {
    Pixels pixels;
    std::uint64_t wish = 0;  ///< number of the request whose state the image shows
    double took_ms = 0;      ///< time from the beginning of drawing until the pixels were read
  };
  /// Swaps the last image with `drawn`, whose memory is used for the next image. Returns false, without a change, if
  /// there is no new image since the last call.
  bool takeFrame(Drawn& drawn);

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
  // The following members are guarded by the mutex.
  int width_px_ = 1, height_px_ = 1;
  std::uint64_t wanted_ = 0, done_ = 0;
  Drawn ready_;
  bool isReady_ = false, ends_ = false;

  Drawn making_;  ///< used by the drawing thread only
  std::thread thread_;
};

}  // namespace insonate::views
