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

/// Base class of all views: a renderer in an OpenGL window that the caller provides, with one view per window. May be
/// used only on the window's thread; a DrawingThread may draw the frames. Setters are fast, since their effects are
/// computed at the next rendering.
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

  /// Renders the window now; if a DrawingThread draws the view, waits for it. Has no effect without a window.
  void render();
  /// Waits until the graphics card, which works asynchronously, has completed the rendered image.
  void finish();
  /// Tells whether a DrawingThread can draw this view.
  virtual bool canDrawOnThread() const { return false; }
  /// Lowers the priority of the view's DrawingThread below that of the window's thread, for a view that is less
  /// important than others. Call it before the first drawing.
  void lowerThreadPriority() { behind_ = true; }
  bool hasLowerPriority() const { return behind_; }

  /// Sets a listener that is called when the view needs rendering. The listener is called often and should combine
  /// several calls into one rendering.
  void setRenderRequested(std::function<void()> listener) { renderRequested_ = std::move(listener); }
  /// Requests a rendering after a change that the view detected itself, for example in shared state.
  void requestRender() const;
  /// Sets a listener that other threads call when they have results to render. The listener must pass the call on to
  /// the window's thread. When setWakeListener() has returned, the previous listener is no longer called.
  void setWakeListener(std::function<void()> listener);

  /// Handlers of user input; each returns true if the view has used the input.
  virtual bool pressed(const Pointer&) { return false; }
  virtual bool moved(const Pointer&) { return false; }
  virtual bool released(const Pointer&) { return false; }
  /// `notches`: rotation of the wheel, positive away from the user; may be a fraction, as from touch pads.
  virtual bool wheel(const Pointer&, double /*notches*/) { return false; }
  virtual bool key(Key) { return false; }
  /// Called when there has been no wheel or key input for a short time. The view can then draw at full resolution
  /// again.
  virtual void inputIdle() {}

  vtkRenderer* renderer() { return renderer_; }

 protected:
  /// Updates the drawing. Called at the beginning of a rendering after changed() or resize().
  virtual void layout() = 0;
  /// Tells whether state shared with other views has changed since the last layout.
  virtual bool isStale() const { return false; }
  virtual void attached(vtkRenderWindow&) {}
  virtual void detached(vtkRenderWindow&) {}

  /// These functions are the steps of drawing a frame. publishState() passes the state of the view, on the window's
  /// thread. adoptState() receives the state, on the drawing thread. draw() draws, on the drawing thread.
  /// publishState() and adoptState() never run at the same time; draw() may run while the window's thread sets new
  /// state.
  virtual void publishState() {}
  virtual void adoptState() {}
  virtual void draw();
  void changed();
  double scale() const { return scale_; }
  vtkRenderWindow* window();
  /// Calls the listener of setWakeListener(). May be called from any thread.
  void wake();

 private:
  friend class DrawingThread;
  void rendererStarts();

  vtkNew<vtkRenderer> renderer_;
  vtkSmartPointer<vtkRenderWindow> window_;
  bool behind_ = false;
  std::function<void()> renderRequested_;
  std::mutex waking_;
  std::function<void()> wake_;  ///< guarded by waking_
  int width_px_ = 1, height_px_ = 1;
  double scale_ = 1;
  std::atomic<bool> stale_{true};
  std::function<void()> renderElsewhere_;  ///< set if a DrawingThread draws the view
};

}  // namespace insonate::views
