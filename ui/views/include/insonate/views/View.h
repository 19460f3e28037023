#pragma once

#include <insonate/views/Input.h>

#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <atomic>
#include <functional>
#include <mutex>

class vtkRenderWindow;

namespace insonate::views {

class DrawingThread;

/// Base of all views: a renderer in a window that the caller provides, one view per window. For the window's thread
/// only; frames may be drawn by a DrawingThread. Setters are fast: their effects are computed at the next rendering.
class View {
 public:
  View();
  virtual ~View();
  View(const View&) = delete;
  View& operator=(const View&) = delete;

  /// Adds the view's renderers to the window; a view can be in one window only.
  void attach(vtkRenderWindow* window);
  void detach();

  /// Sets the window's size in device pixels, and the number of device pixels per logical pixel, by which text and
  /// margins are scaled. Call it after the window has this size.
  void resize(int width_px, int height_px, double scale = 1);
  int width_px() const { return width_px_; }
  int height_px() const { return height_px_; }

  /// Renders the window now; if a DrawingThread draws the view, waits for it. No effect without a window.
  void render();
  /// Waits until the rendered image is complete, since graphics cards work asynchronously.
  void finish();
  /// Tells whether a DrawingThread can draw this view.
  virtual bool canDrawOnThread() const { return false; }
  /// Lowers the priority of the view's DrawingThread below the window's, if other views are more important. Call it
  /// before the first drawing.
  void lowerThreadPriority() { behind_ = true; }
  bool hasLowerPriority() const { return behind_; }

  /// Sets a listener that is called when the view needs rendering. It is called often: combine calls before rendering.
  void setRenderWanted(std::function<void()> listener) { renderWanted_ = std::move(listener); }
  /// Requests a rendering after a change that the view detected itself, for example in shared state.
  void wantRender() const;
  /// Sets a listener that is called on other threads when they have results to render; it must pass the call on to the
  /// window's thread. When this function returns, the former listener is no longer called.
  void setWake(std::function<void()> listener);

  /// Input functions; they return true if the view has used the input.
  virtual bool pressed(const Pointer&) { return false; }
  virtual bool moved(const Pointer&) { return false; }
  virtual bool released(const Pointer&) { return false; }
  /// `notches` is positive for turning away from the user; touch pads send fractions.
  virtual bool wheel(const Pointer&, double /*notches*/) { return false; }
  virtual bool key(Key) { return false; }
  /// Called after a short time without wheel and keys: drawings that had a lower resolution because of them can be
  /// completed.
  virtual void rested() {}

  vtkRenderer* renderer() { return renderer_; }

 protected:
  /// Updates the drawing. Called at the beginning of a rendering after changed() or resize().
  virtual void layout() = 0;
  /// Tells whether state shared with other views has changed since the last layout.
  virtual bool outOfDate() const { return false; }
  virtual void attached(vtkRenderWindow&) {}
  virtual void detached(vtkRenderWindow&) {}

  /// Steps of drawing a frame: handOver() on the window's thread passes the state, takeOver() on the drawing thread
  /// receives it, and draw() draws. The first two never run at the same time; draw() may run while the view gets a new
  /// state.
  virtual void handOver() {}
  virtual void takeOver() {}
  virtual void draw();
  void changed();
  double scale() const { return scale_; }
  vtkRenderWindow* window();
  /// Wakes the window; call from any thread.
  void wake();

 private:
  friend class DrawingThread;
  void rendererStarts();

  vtkNew<vtkRenderer> renderer_;
  vtkSmartPointer<vtkRenderWindow> window_;
  bool behind_ = false;
  std::function<void()> renderWanted_;
  std::mutex waking_;
  std::function<void()> wake_;  ///< guarded by waking_
  int width_px_ = 1, height_px_ = 1;
  double scale_ = 1;
  std::atomic<bool> stale_{true};
  std::function<void()> renderElsewhere_;  ///< set if a DrawingThread draws the view
};

}  // namespace insonate::views
