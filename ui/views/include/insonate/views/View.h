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

/// Base of all views: a renderer in a window that the caller provides. One view to a window. For the window's thread
/// only, except for its frames if a DrawingThread makes them. Setters are cheap: their effects are computed when the
/// view is rendered next.
class View {
 public:
  View();
  virtual ~View();
  View(const View&) = delete;
  View& operator=(const View&) = delete;

  /// Adds the view's renderers to the window; a view is in one window at most.
  void attach(vtkRenderWindow* window);
  void detach();

  /// The window's size in device pixels, and device pixels to a logical one (text and margins grow by it). Call it
  /// when the window has that size.
  void resize(int width_px, int height_px, double scale = 1);
  int width_px() const { return width_px_; }
  int height_px() const { return height_px_; }

  /// Renders the window now; where a DrawingThread does that, waits for it. Nothing happens without a window.
  void render();
  /// Waits until the rendered image is complete: graphics cards work asynchronously.
  void finish();
  /// Tells whether a DrawingThread can draw it.
  virtual bool canDrawOnThread() const { return false; }
  /// Lowers the priority of a DrawingThread below the window's, if other views matter more. Call before it is first
  /// drawn.
  void lowerThreadPriority() { behind_ = true; }
  bool hasLowerPriority() const { return behind_; }

  /// Sets a listener that is called when the view needs rendering; called often, so collect before rendering.
  void setRenderWanted(std::function<void()> listener) { renderWanted_ = std::move(listener); }
  /// Requests a rendering, for changes that views detect themselves, for example in shared state.
  void wantRender() const;
  /// Sets a listener that is called on other threads when they have results to render: pass it on to the window's
  /// thread. After this returns, the former listener is not called any more.
  void setWake(std::function<void()> listener);

  /// Input; true when the view made use of it.
  virtual bool pressed(const Pointer&) { return false; }
  virtual bool moved(const Pointer&) { return false; }
  virtual bool released(const Pointer&) { return false; }
  /// Positive notches are away from the user; fractions come from touch pads.
  virtual bool wheel(const Pointer&, double /*notches*/) { return false; }
  virtual bool key(Key) { return false; }
  /// Called after a moment without wheel and keys: drawings that were coarser for them may become exact again.
  virtual void rested() {}

  vtkRenderer* renderer() { return renderer_; }

 protected:
  /// Updates the drawing. Called at the start of a rendering after changed() or resize().
  virtual void layout() = 0;
  /// Tells whether state shared with other views has changed since the last layout.
  virtual bool outOfDate() const { return false; }
  virtual void attached(vtkRenderWindow&) {}
  virtual void detached(vtkRenderWindow&) {}

  /// A frame is made in three steps: the window's thread passes the state, the drawing thread takes it, and draws. The
  /// first two never run at once; the last may run while the view receives a new state.
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
  std::function<void()> wake_;  ///< guarded by the mutex
  int width_px_ = 1, height_px_ = 1;
  double scale_ = 1;
  std::atomic<bool> stale_{true};
  std::function<void()> renderElsewhere_;  ///< set while a DrawingThread draws
};

}  // namespace insonate::views
